#include <iostream>
#include <vector>

#include <nanoflann.hpp>

struct Line
{
  std::vector<double> at;
  size_t kdtree_get_point_count() const { return at.size(); }
  double kdtree_get_pt(size_t index, size_t) const { return at[index]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};

int main()
{
  const Line line{{0.0, 4.0, 7.0}};
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Line>, Line, 1>;
  Tree tree(1, line);
  tree.buildIndex();
  const double asked = 6.0;
  size_t index = 0;
  double distance = 0.0;
  nanoflann::KNNResultSet<double> result(1);
  result.init(&index, &distance);
  tree.findNeighbors(result, &asked, nanoflann::SearchParams());
  std::cout << "nearest: " << index << std::endl;
}
