// The filter needs neither physics nor pictures.
#include <iostream>

#include "slam/fast_slam.hpp"

int main() {
  cogslam::SlamConfig config;
  config.check();
  std::cout << config.particles << " particles\n";
}
