// Sizes: from what the scene asks for to a list of particles with radius, material and species.
//
// The list is in the order of the ids: species by species, class by class as the scene lists them;
// a distribution runs from its coarse end to its fine end. Particle i's diameter is a function of
// (seed, i) and of its class. Positions are set for explicit particles only; scheduler/fill places
// the rest. A species' diameters are those of spheres of equal volume; its polyhedra are dealt its
// meshes in turn by identity, and orientations that are a function of (seed, i).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "soa/scene.h"

namespace quern {

inline constexpr std::uint16_t kNoMesh = 0xffff;

struct ParticleSeed {
  Vec3 position = Vec3::Zero();  // m
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();      // rad/s
  double radius = 0;             // m; of a polyhedron that of the sphere of equal volume
  std::uint16_t material = 0;    // row of scene.materials
  std::uint16_t species = 0;     // row of scene.particles
  std::uint16_t mesh = kNoMesh;  // row of the species' meshes; kNoMesh: a sphere
  const Shape* shape = nullptr;  // of a polyhedron, see assign_shapes()
  // Of the mesh as it lies in its file, before assign_shapes(); then of the body frame.
  Quat orientation = Quat::Identity();

  bool is_sphere() const { return mesh == kNoMesh; }
  // Radii about the centre within which all of the particle lies, and nothing else (m).
  double reach() const { return shape == nullptr ? radius : shape->bound_radius * radius; }
  double inner() const { return shape == nullptr ? radius : shape->inner_radius * radius; }
};

// Solid share of the bulk that a filling level counts (porosity 0.4).
inline constexpr double kBulkSolidFraction = 0.6;

// Amounts: counts are exact; a mass or filling level is met to half a particle, in every class of a
// list with mass shares (the last class' finest particle for a distribution). A table of passing is
// cut to its first and last diameter and log-linear between its points; Rosin-Rammler is cut to
// [from, to]. Throws UserError where the scene contradicts itself (no amount, unknown material
// ...).
std::vector<ParticleSeed> draw_sizes(const Scene& scene);

// How many those will be, without drawing them: of a mass or filling level as expected.
struct ParticleCount {
  double spheres = 0, polyhedra = 0;
};
ParticleCount count_particles(const Scene& scene);

// Gives polyhedra their shape: mesh k of species s is shapes[species_shapes[s][k]]. Seeds point
// into `shapes`, whose memory has to stay (moving the vector keeps it).
void assign_shapes(std::span<const Shape> shapes,
                   std::span<const std::vector<Index>> species_shapes,
                   std::vector<ParticleSeed>& particles);

// Name of a species for messages: 'name', or its place in the scene.
std::string species_label(const Scene& scene, std::size_t species);

// Explicit particles come with their place; all others wait for scheduler/fill.
bool is_explicit(const Scene& scene, const ParticleSeed& particle);

double sphere_volume(double radius);

}  // namespace quern
