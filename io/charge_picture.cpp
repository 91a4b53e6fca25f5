// SVG by hand: y points down in the file, so angles are turned when points are written, here alone.
#include "io/charge_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quern {
namespace {

constexpr double kWidth = 1120, kHeight = 850;
constexpr double kCenterX = 560, kCenterY = 460, kShell = 300;  // pixels
constexpr int kColours = 24;
constexpr double kDegree = kPi / 180;

struct Colour {
  double red, green, blue;
};

// From almost white over blue to dark blue, darker throughout: it reads in grey as well.
constexpr Colour kRamp[] = {{253, 253, 254}, {203, 220, 236}, {144, 185, 216},
                            {82, 141, 188},  {37, 92, 148},   {15, 44, 92}};

std::string colour(double share) {
  constexpr int kLast = static_cast<int>(std::size(kRamp)) - 1;
  const double at = std::clamp(share, 0.0, 1.0) * kLast;
  const int low = std::min(static_cast<int>(at), kLast - 1);
  const double t = at - low;
  const Colour &a = kRamp[low], &b = kRamp[low + 1];
  const auto mix = [t](double x, double y) {
    return static_cast<int>(std::lround(x + t * (y - x)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(a.red, b.red), mix(a.green, b.green),
                     mix(a.blue, b.blue));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

// "x y" of a place given in pixels from the axis.
std::string place(double radius, double angle) {
  return fmt::format("{:.1f} {:.1f}", kCenterX + radius * std::cos(angle),
                     kCenterY - radius * std::sin(angle));
}

// Scale of the colours: the bed's fraction and a little more, in tenths.
double top_of(const ChargeShape& shape) {
  return std::max(0.1, std::ceil(10.5 * shape.bed_fraction) / 10);
}

struct Drawing {
  const ChargePicture& picture;
  double scale;  // pixels per metre
  std::string out;

  explicit Drawing(const ChargePicture& p) : picture(p), scale(kShell / p.grid.radius) {}

  void text(double x, double y, const char* style, const std::string& words) {
    out +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, escaped(words));
  }
};

// The cells with rings joined in groups of `group`: mean fraction of each.
std::vector<double> grouped(const PolarGrid& grid, const std::vector<double>& fraction, int group) {
  const int rows = (grid.rings + group - 1) / group;
  std::vector<double> sum(static_cast<std::size_t>(rows * grid.angles), 0);
  for (int row = 0; row < rows; ++row) {
    const int last = std::min(grid.rings, (row + 1) * group);
    double area = 0;
    for (int ring = row * group; ring < last; ++ring) area += grid.area(ring);
    for (int ring = row * group; ring < last; ++ring) {
      for (int a = 0; a < grid.angles; ++a) {
        sum[grid.cell(row, a)] += fraction[grid.cell(ring, a)] * grid.area(ring) / area;
      }
    }
  }
  return sum;
}

// A piece of ring between two radii (pixels) and two angles; less than half a turn.
std::string ring_piece(double inner, double outer, double from, double to) {
  return fmt::format("M{}A{:.1f} {:.1f} 0 0 0 {}L{}A{:.1f} {:.1f} 0 0 1 {}Z", place(outer, from),
                     outer, outer, place(outer, to), place(inner, to), inner, inner,
                     place(inner, from));
}

void draw_cells(Drawing& drawing) {
  const PolarGrid& grid = drawing.picture.grid;
  const double width = grid.ring_width() * drawing.scale, top = top_of(drawing.picture.shape);
  const int group = std::max(1, static_cast<int>(std::ceil(2 / width)));
  const std::vector<double> mean = grouped(grid, drawing.picture.shape.fraction, group);
  const auto level = [&](int row, int a) {
    return std::min(static_cast<int>(mean[grid.cell(row, a)] / top * kColours), kColours - 1);
  };
  std::vector<std::string> paths(kColours);
  const int longest = grid.angles / 4;
  for (int row = 0; row * group < grid.rings; ++row) {
    const double inner = row * group * width;
    const double outer = std::min(grid.rings, (row + 1) * group) * width;
    for (int a = 0; a < grid.angles;) {
      int end = a + 1;
      while (end < grid.angles && end - a < longest && level(row, end) == level(row, a)) ++end;
      if (mean[grid.cell(row, a)] > 0) {
        paths[static_cast<std::size_t>(level(row, a))] +=
            ring_piece(inner, outer, a * grid.angle_step(), end * grid.angle_step());
      }
      a = end;
    }
  }
  drawing.out += "<g stroke-width=\"0.6\">\n";
  for (int k = 0; k < kColours; ++k) {
    const std::string& path = paths[static_cast<std::size_t>(k)];
    if (path.empty()) continue;
    drawing.out += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n",
                               colour(static_cast<double>(k) / (kColours - 1)), path);
  }
  drawing.out += "</g>\n";
}

// The sides of cells between the bulk and the rest.
void draw_bulk(Drawing& drawing) {
  const PolarGrid& grid = drawing.picture.grid;
  const std::vector<std::uint8_t>& bulk = drawing.picture.shape.bulk;
  const double width = grid.ring_width() * drawing.scale, step = grid.angle_step();
  std::string path;
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int a = 0; a < grid.angles; ++a) {
      const bool here = bulk[grid.cell(ring, a)] != 0;
      const bool next = bulk[grid.cell(ring, (a + 1) % grid.angles)] != 0;
      const double side = (a + 1) * step, outer = (ring + 1) * width;
      if (here != next) {
        path += fmt::format("M{}L{}", place(ring * width, side), place(outer, side));
      }
      const bool beyond = ring + 1 < grid.rings && bulk[grid.cell(ring + 1, a)] != 0;
      if (here == beyond) continue;
      path += fmt::format("M{}A{:.1f} {:.1f} 0 0 0 {}", place(outer, a * step), outer, outer,
                          place(outer, side));
    }
  }
  drawing.out += fmt::format(
      "<path fill=\"none\" stroke=\"#d9480f\" stroke-width=\"1.6\" stroke-linecap=\"round\" "
      "d=\"{}\"/>\n",
      path);
}

void draw_liner(Drawing& drawing) {
  const double rim = 1.03 * kShell;
  std::string path = fmt::format("M{}A{:.1f} {:.1f} 0 0 0 {}A{:.1f} {:.1f} 0 0 0 {}Z",
                                 place(rim, 0), rim, rim, place(rim, kPi), rim, rim, place(rim, 0));
  for (const Eigen::Vector2d& corner : drawing.picture.profile) {
    path += &corner == &drawing.picture.profile.front() ? "M" : "L";
    path += place(corner.norm() * drawing.scale, std::atan2(corner.y(), corner.x()));
  }
  if (!drawing.picture.profile.empty()) path += "Z";
  drawing.out += fmt::format(
      "<path fill=\"#8a8f98\" fill-opacity=\"0.45\" fill-rule=\"evenodd\" stroke=\"#4b5563\" "
      "stroke-width=\"1\" d=\"{}\"/>\n",
      path);
  for (int degree = -90; degree < 270; degree += 30) {
    const double angle = degree * kDegree;
    drawing.out += fmt::format("<path stroke=\"#4b5563\" d=\"M{}L{}\"/>\n", place(rim, angle),
                               place(rim + 6, angle));
    drawing.text(
        kCenterX + (rim + 20) * std::cos(angle), kCenterY - (rim + 20) * std::sin(angle) + 4,
        "font-size=\"12\" fill=\"#6b7280\" text-anchor=\"middle\"", fmt::format("{}°", degree));
  }
}

// An arrow outside the shell, at its top.
void draw_direction(Drawing& drawing) {
  const double radius = 1.15 * kShell, sign = drawing.picture.direction > 0 ? 1 : -1;
  const double from = kPi / 2 - sign * 10 * kDegree, to = kPi / 2 + sign * 10 * kDegree;
  drawing.out += fmt::format(
      "<path fill=\"none\" stroke=\"#374151\" stroke-width=\"2\" "
      "d=\"M{}A{:.1f} {:.1f} 0 0 {} {}\"/>\n",
      place(radius, from), radius, radius, sign > 0 ? 0 : 1, place(radius, to));
  const double tip = to + sign * 2.5 * kDegree;
  drawing.out += fmt::format("<path fill=\"#374151\" d=\"M{}L{}L{}Z\"/>\n", place(radius, tip),
                             place(radius - 5, to), place(radius + 5, to));
}

std::string ray_label(const ChargePicture::Ray& ray) {
  std::string angle = fmt::format("{} {:.1f}°", ray.name, ray.angle / kDegree);
  if (!std::isfinite(ray.error)) return angle;
  return angle + fmt::format(" ± {:.1f}°", ray.error / kDegree);
}

// Labels on one side of the mill keep a line's distance.
void draw_rays(Drawing& drawing) {
  constexpr double kLine = 18, kInner = 1.03 * kShell, kOuter = 1.13 * kShell;
  std::vector<std::pair<double, const ChargePicture::Ray*>> left, right;
  for (const ChargePicture::Ray& ray : drawing.picture.rays) {
    auto& side = std::cos(ray.angle) < 0 ? left : right;
    side.emplace_back(kCenterY - 1.15 * kShell * std::sin(ray.angle) + 5, &ray);
  }
  for (auto* side : {&left, &right}) {
    std::sort(side->begin(), side->end());
    for (std::size_t k = 1; k < side->size(); ++k) {
      (*side)[k].first = std::max((*side)[k].first, (*side)[k - 1].first + kLine);
    }
    for (const auto& [y, ray] : *side) {
      drawing.out += fmt::format(
          "<path stroke=\"#b91c1c\" stroke-width=\"1.5\" stroke-dasharray=\"7 4\" d=\"M{}L{}\"/>\n"
          "<path stroke=\"#b91c1c\" stroke-width=\"1.5\" d=\"M{}L{}\"/>\n",
          place(0, 0), place(kInner, ray->angle), place(kInner, ray->angle),
          place(kOuter, ray->angle));
      if (ray->radius > 0) {
        const double out = ray->radius * drawing.scale;
        drawing.out += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#b91c1c\"/>\n",
            kCenterX + out * std::cos(ray->angle), kCenterY - out * std::sin(ray->angle));
      }
      const double x = kCenterX + 1.15 * kShell * std::cos(ray->angle);
      drawing.text(x, y,
                   side == &left
                       ? "font-size=\"15\" font-weight=\"600\" fill=\"#b91c1c\" text-anchor=\"end\""
                       : "font-size=\"15\" font-weight=\"600\" fill=\"#b91c1c\"",
                   ray_label(*ray));
    }
  }
}

void draw_scale(Drawing& drawing) {
  constexpr double kLeft = kCenterX - 180, kTop = kHeight - 34, kLong = 360, kHigh = 12;
  const double top = top_of(drawing.picture.shape);
  for (int k = 0; k < kColours; ++k) {
    drawing.out +=
        fmt::format("<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
                    kLeft + k * kLong / kColours, kTop, kLong / kColours + 0.5, kHigh,
                    colour(static_cast<double>(k) / (kColours - 1)));
  }
  const int tenths = static_cast<int>(std::lround(10 * top));
  for (int k = 0; k <= tenths; ++k) {
    drawing.text(kLeft + k * kLong / tenths, kTop + kHigh + 15,
                 "font-size=\"12\" fill=\"#374151\" text-anchor=\"middle\"",
                 fmt::format("{}{:.1f}", k == tenths ? "≥ " : "", k / 10.0));
  }
  drawing.text(kLeft - 10, kTop + kHigh - 1,
               "font-size=\"13\" fill=\"#374151\" text-anchor=\"end\"", "solid fraction");
}

}  // namespace

std::string charge_svg(const ChargePicture& picture) {
  QUERN_CHECK(picture.shape.fraction.size() == picture.grid.cells());
  QUERN_CHECK(picture.shape.bulk.size() == picture.grid.cells());
  Drawing drawing(picture);
  drawing.out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      kWidth, kHeight, escaped(picture.title));
  drawing.text(24, 34, "font-size=\"19\" font-weight=\"600\" fill=\"#111827\"", picture.title);
  for (std::size_t k = 0; k < picture.notes.size(); ++k) {
    drawing.text(24, 58 + 19 * static_cast<double>(k), "font-size=\"14\" fill=\"#374151\"",
                 picture.notes[k]);
  }
  draw_cells(drawing);
  draw_liner(drawing);
  draw_bulk(drawing);
  draw_direction(drawing);
  draw_rays(drawing);
  draw_scale(drawing);
  return drawing.out + "</svg>\n";
}

}  // namespace quern
