"""A git server, reached by ssh on the loopback alone with one key; it starts nothing but ``git upload-pack``."""

from __future__ import annotations

import asyncio
import shlex
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import asyncssh


@dataclass
class SshServer:
    """One that runs: its address, the key that it takes, and how often it was let in."""

    port: int
    key: str
    """The private key, as ssh-keygen writes it."""
    served: int = 0

    def url(self, repository: Path) -> str:
        """Return the address of a repository on this machine."""
        return f"ssh://git@127.0.0.1:{self.port}{repository}"


@contextmanager
def ssh_server(folder: Path) -> Iterator[SshServer]:
    """Serve the git repositories below ``folder``, read only, while the context lasts."""
    key, host = (asyncssh.generate_private_key("ssh-ed25519") for _ in range(2))
    server = SshServer(port=0, key=key.export_private_key().decode())

    async def serve(process: asyncssh.SSHServerProcess[bytes]) -> None:
        program, path, *rest = [*shlex.split(process.command or ""), "", ""]
        repository = Path(path)
        if program != "git-upload-pack" or any(rest[:-2]) or not repository.is_relative_to(folder):
            process.stderr.write(b"only git-upload-pack is served\n")
            process.exit(1)
            return
        server.served += 1
        git = await asyncio.create_subprocess_exec(
            "git", "upload-pack", str(repository), stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE
        )
        asking = asyncio.create_task(_copy(process.stdin, git.stdin))
        await _copy(git.stdout, process.stdout)
        asking.cancel()
        process.exit(await git.wait())

    async def listen() -> asyncssh.SSHAcceptor:
        allowed = asyncssh.import_authorized_keys(key.export_public_key().decode())
        return await asyncssh.listen(
            "127.0.0.1", 0, server_host_keys=[host], authorized_client_keys=allowed, process_factory=serve,
            encoding=None, allow_scp=False,
        )  # fmt: skip

    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever)
    thread.start()
    try:
        acceptor = asyncio.run_coroutine_threadsafe(listen(), loop).result(60)
        server.port = acceptor.get_port()
        yield server
        acceptor.close()
        asyncio.run_coroutine_threadsafe(acceptor.wait_closed(), loop).result(60)
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()


async def _copy(source: Any, target: Any) -> None:
    """Pass on what comes until nothing more does."""
    while data := await source.read(1 << 16):
        target.write(data)
        await target.drain()
