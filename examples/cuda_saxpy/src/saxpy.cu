// SPDX-License-Identifier: Apache-2.0
// y = a x + y for a million numbers on the GPU, compared with the same on the CPU.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include <cuda_runtime.h>

namespace
{

constexpr int SIZE = 1 << 20;
constexpr int THREADS = 256;

__global__ void saxpy(int size, float a, const float* x, float* y)
{
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < size) {
    y[i] = a * x[i] + y[i];
  }
}

std::vector<float> on_cpu(float a, const std::vector<float>& x, std::vector<float> y)
{
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] = a * x[i] + y[i];
  }
  return y;
}

/// Returns an empty vector where a call of CUDA failed; the reason is on standard error.
std::vector<float> on_gpu(float a, const std::vector<float>& x, std::vector<float> y)
{
  const std::size_t bytes = x.size() * sizeof(float);
  float* device_x = nullptr;
  float* device_y = nullptr;
  cudaMalloc(&device_x, bytes);
  cudaMalloc(&device_y, bytes);
  cudaMemcpy(device_x, x.data(), bytes, cudaMemcpyHostToDevice);
  cudaMemcpy(device_y, y.data(), bytes, cudaMemcpyHostToDevice);
  const int size = static_cast<int>(x.size());
  saxpy<<<(size + THREADS - 1) / THREADS, THREADS>>>(size, a, device_x, device_y);
  cudaMemcpy(y.data(), device_y, bytes, cudaMemcpyDeviceToHost);
  cudaFree(device_x);
  cudaFree(device_y);
  // Errors stay until they are asked for: one question answers for all calls above
  const cudaError_t error = cudaGetLastError();
  if (error != cudaSuccess) {
    std::fprintf(stderr, "saxpy: %s\n", cudaGetErrorString(error));
    y.clear();
  }
  return y;
}

}  // namespace

int main(int argc, char** argv)
{
  const bool cpu_only = argc > 1 && std::strcmp(argv[1], "--cpu") == 0;
  const float a = 2.0f;
  std::vector<float> x(SIZE), y(SIZE, 1.0f);
  for (int i = 0; i < SIZE; ++i) {
    x[i] = static_cast<float>(i % 1000);
  }
  const std::vector<float> expected = on_cpu(a, x, y);
  if (cpu_only) {
    std::printf("CPU only: y[999] = %.1f\n", expected[999]);
    return expected[999] == 1999.0f ? 0 : 1;
  }

  int devices = 0;
  const cudaError_t found = cudaGetDeviceCount(&devices);
  if (found != cudaSuccess || devices == 0) {
    std::fprintf(stderr, "saxpy: no GPU is visible (%s).\n", cudaGetErrorString(found));
    std::fprintf(stderr, "Start the container with `--gpus all`, or run `saxpy --cpu`.\n");
    return 2;
  }
  cudaDeviceProp properties;
  cudaGetDeviceProperties(&properties, 0);
  const std::vector<float> result = on_gpu(a, x, y);
  if (result.empty()) {
    return 1;
  }
  float worst = 0.0f;
  for (int i = 0; i < SIZE; ++i) {
    worst = std::fmax(worst, std::fabs(result[i] - expected[i]));
  }
  std::printf("%s: y[999] = %.1f, largest difference from the CPU %g\n", properties.name, result[999], worst);
  return worst < 1e-3f ? 0 : 1;
}
