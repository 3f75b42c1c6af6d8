# A window with an orange disc, drawn with what every Ubuntu and Debian holds: nothing is installed for it, which takes
# long on an emulated machine. https://www.x.org/releases/X11R7.7/doc/xproto/x11protocol.html
use strict;
use warnings;
use Socket;

my ($number) = ($ENV{DISPLAY} // "") =~ /^:(\d+)/ or die "no \$DISPLAY\n";
open my $file, "<:raw", $ENV{XAUTHORITY} // "" or die "no key: $!\n";
my (undef, undef, undef, $kind, $key) = unpack "n n/a n/a n/a n/a", do { local $/; <$file> };

socket my $server, PF_UNIX, SOCK_STREAM, 0 or die "$!\n";
connect $server, pack_sockaddr_un("/tmp/.X11-unix/X$number") or die "no display :$number: $!\n";
tell_it(pack "a x v4 x2 a* x!4 a* x!4", "l", 11, 0, length $kind, length $key, $kind, $key);
my ($status, $length) = unpack "C x5 v", hear(8);
my $setup = hear(4 * $length);
$status == 1 or die "couldn't connect to display: $setup\n";
my ($base, $vendor, $formats) = unpack "x4 V x8 v x3 C", $setup;
my ($root, undef, $white) = unpack "V3", substr $setup, 32 + ($vendor + 3 & ~3) + 8 * $formats;

my ($window, $context, $orange, $exposure) = ($base, $base + 1, 0xFFA500, 1 << 15);
tell_it(pack "C x v V2 v6 V4", 1, 10, $window, $root, 100, 80, 640, 480, 0, 1, 0, 1 << 1 | 1 << 11, $white, $exposure);
tell_it(pack "C x v V4", 55, 5, $context, $window, 1 << 2, $orange);
tell_it(pack "C x v V", 8, 2, $window);
while (1) {
    my $event = unpack "C", hear(32);
    die "the server refuses a request\n" if $event == 0;
    tell_it(pack "C x v V2 v6", 71, 6, $window, $context, 120, 40, 400, 400, 0, 360 * 64) if $event == 12;
}

sub tell_it {
    my ($request) = @_;
    syswrite($server, $request) == length $request or die "$!\n";
}

sub hear {
    my ($size) = @_;
    my $said = "";
    sysread $server, $said, $size - length $said, length $said or die "the server is gone\n" while length $said < $size;
    return $said;
}
