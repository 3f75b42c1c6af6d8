// SPDX-License-Identifier: Apache-2.0
// Prints what the talker says; with the parameter `messages` set, ends after so many.
#include <cstdint>
#include <memory>

#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

class Listener : public rclcpp::Node
{
public:
  Listener() : Node("listener"), wanted_(declare_parameter<std::int64_t>("messages", 0))  // 0: listen for ever
  {
    chatter_ = create_subscription<std_msgs::msg::String>(
      "chatter", 10, [this](const std_msgs::msg::String& message) {
        RCLCPP_INFO(get_logger(), "I heard: %s", message.data.c_str());
        if (++heard_ == wanted_) {
          rclcpp::shutdown();
        }
      });
  }

private:
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr chatter_;
  std::int64_t wanted_;
  std::int64_t heard_ = 0;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Listener>());
  rclcpp::shutdown();
  return 0;
}
