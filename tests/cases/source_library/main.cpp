#include <pangolin/pangolin.h>

int main()
{
  pangolin::CreateWindowAndBind("path", 640, 480);
  while (!pangolin::ShouldQuit())
    pangolin::FinishFrame();
}
