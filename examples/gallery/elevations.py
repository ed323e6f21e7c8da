"""Scattered elevations as a shaded relief on quads; what lies between the points is interpolated on them."""
# Needs the extra: pip install ".[plot]"
import matplotlib.pyplot as plt
import numpy as np

import quadloom

random = np.random.default_rng(4)
x, y = random.uniform(-3, 3, (2, 900))
z = 3 * (1 - x)**2 * np.exp(-x**2 - (y + 1)**2) - 10 * (x / 5 - x**3 - y**5) * np.exp(-x**2 - y**2)
mesh = quadloom.convex_quadrangulation(np.column_stack([x, y, z]))

figure, ax = plt.subplots(figsize=(7, 5.6), layout="constrained")
relief = mesh.plot(ax, colour=mesh.points[:, 2], cmap="terrain", alpha=0.9)
figure.colorbar(relief, label="elevation")
ax.set_title(f"{len(z)} elevations, {len(mesh.quads)} strictly convex quads, {mesh.is_steiner.sum()} points added")
figure.savefig("elevations.png", dpi=72)
