# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of ocean models with known flows: a map of its own, and one file of each kind of grid."""
import numpy as np
from classic_netcdf import Variable, write

SEMI_MAJOR, FLATTENING = 6378137.0, 1.0 / 298.257223563
E2 = FLATTENING * (2.0 - FLATTENING)
E = np.sqrt(E2)


def conformal(latitude):
    """Conformal latitude [rad] (Snyder 1987, eq. 3-1)."""
    s = E * np.sin(latitude)
    return 2.0 * np.arctan(np.tan(np.pi / 4 + latitude / 2) * ((1 - s) / (1 + s)) ** (E / 2)) - np.pi / 2


def to_map(longitude, latitude, origin):
    """Stereographic map of the ellipsoid about an origin, degrees to metres (Snyder 1987, eqs. 21-24 to 21-27)."""
    lam = np.radians(longitude) - np.radians(origin[0])
    chi, chi1, phi1 = conformal(np.radians(latitude)), conformal(np.radians(origin[1])), np.radians(origin[1])
    m1 = np.cos(phi1) / np.sqrt(1 - E2 * np.sin(phi1) ** 2)
    far = 1 + np.sin(chi1) * np.sin(chi) + np.cos(chi1) * np.cos(chi) * np.cos(lam)
    a = 2 * SEMI_MAJOR * m1 / (np.cos(chi1) * far)
    return np.array([a * np.cos(chi) * np.sin(lam),
                     a * (np.cos(chi1) * np.sin(chi) - np.sin(chi1) * np.cos(chi) * np.cos(lam))])


def radii(latitude):
    """Radii of a parallel and of the meridian [m]."""
    w = np.sqrt(1 - E2 * np.sin(np.radians(latitude)) ** 2)
    return SEMI_MAJOR * np.cos(np.radians(latitude)) / w, SEMI_MAJOR * (1 - E2) / w ** 3


def on_earth(longitude, latitude, origin, flow):
    """Eastward and northward velocities [m/s] on earth of a flow(x, y) on the map, by differences of the map."""
    step = 1e-4
    along, up = radii(latitude)
    d = np.degrees(step)
    east = (to_map(longitude + d, latitude, origin) - to_map(longitude - d, latitude, origin)) / (2 * step * along)
    north = (to_map(longitude, latitude + d, origin) - to_map(longitude, latitude - d, origin)) / (2 * step * up)
    u, v = flow(*to_map(longitude, latitude, origin))
    det = east[0] * north[1] - east[1] * north[0]
    return (u * north[1] - v * north[0]) / det, (east[0] * v - east[1] * u) / det


def inverse(x, y, origin):
    """Longitude and latitude [degrees] of a place on the map, by Newton's method."""
    place = np.array([np.full_like(x, origin[0]), np.full_like(x, origin[1])])
    for _ in range(12):
        along, up = radii(place[1])
        now = to_map(*place, origin)
        d = 1e-6
        east = (to_map(place[0] + d, place[1], origin) - now) / d
        north = (to_map(place[0], place[1] + d, origin) - now) / d
        det = east[0] * north[1] - east[1] * north[0]
        miss = x - now[0], y - now[1]
        place = place + np.array([miss[0] * north[1] - miss[1] * north[0], east[0] * miss[1] - east[1] * miss[0]]) / det
    return place


def axis(name, values, kind="f8", **attributes):
    return Variable(name, np.asarray(values, dtype=float), kind, **attributes)


EAST, NORTH = dict(units="degrees_east"), dict(units="degrees_north")


def times(values, units="seconds since 2020-01-01 00:00:00", **more):
    return Variable("time", np.asarray(values, dtype=float), "f8", units=units, **more)


def regular(path, flow, origin, lons, lats, seconds, depths=None, kind="f8", **packing):
    """A file on axes of longitudes and latitudes of a flow(x, y, z, t); velocities eastwards and northwards."""
    lon, lat = np.meshgrid(np.asarray(lons, float), np.asarray(lats, float))
    levels = [0.0] if depths is None else depths
    u = np.empty((len(seconds), len(levels)) + lon.shape)
    v = np.empty_like(u)
    for n, t in enumerate(seconds):
        for k, depth in enumerate(levels):
            u[n, k], v[n, k] = on_earth(lon, lat, origin, lambda x, y: flow(x, y, -depth, t))
    dimensions = {"time": len(seconds), "depth": len(levels), "lat": len(lats), "lon": len(lons)}
    dims = "time depth lat lon"
    variables = {"time": times(seconds), "lat": axis("lat", lats, **NORTH), "lon": axis("lon", lons, **EAST)}
    if depths is None:
        dimensions.pop("depth")
        dims, u, v = "time lat lon", u[:, 0], v[:, 0]
    else:
        variables["depth"] = axis("depth", depths, units="m", positive="down")
    scale, offset = packing.get("scale_factor", 1.0), packing.get("add_offset", 0.0)
    for name, standard, values in (("uo", "eastward", u), ("vo", "northward", v)):
        stored = (values - offset) / scale
        stored = np.rint(stored) if kind[0] == "i" else stored
        stored = np.where(np.isnan(stored), packing.get("_FillValue", np.nan), stored)
        variables[name] = Variable(dims, stored, kind, standard_name=f"{standard}_sea_water_velocity", units="m s-1",
                                   **packing)
    write(path, dimensions, variables)


def levels_of(s, stretch, critical, transform, h, zeta):
    """Heights of s levels by ROMS's transforms, each level over the arrays of depths and surface heights."""
    s, stretch = np.asarray(s)[:, None, None], np.asarray(stretch)[:, None, None]
    if transform == 1:
        still = critical * s + (h - critical) * stretch
        return still + zeta * (1.0 + still / h)
    return zeta + (zeta + h) * (critical * s + h * stretch) / (critical + h)


def roms(path, flow, origin, corner, turn, spacing, shape, seconds, h, zeta, transform=2, land=None, drop=(), **more):
    """
    A C grid, turned on the map, of a flow(x, y, z, t): h(x, y), zeta(x, y, t), mask of land by rho points. Returns the
    places of the inner rho points and their heights at each time.
    """
    rows, columns = shape
    i, j = np.meshgrid(np.arange(columns, dtype=float), np.arange(rows, dtype=float))
    cos, sin = np.cos(turn), np.sin(turn)

    def places(di, dj, cut):
        a, b = (i + di) * spacing, (j + dj) * spacing
        x, y = corner[0] + cos * a - sin * b, corner[1] + sin * a + cos * b
        return tuple(p[cut] for p in (x, y))

    whole = np.s_[:, :]
    rho, at_u, at_v = places(0, 0, whole), places(0.5, 0, np.s_[:, :-1]), places(0, 0.5, np.s_[:-1, :])
    count, theta_s, theta_b, hc = 6, 5.0, 0.8, 15.0
    s = (np.arange(count) + 0.5) / count - 1.0
    cs = (1 - np.cosh(theta_s * s)) / (np.cosh(theta_s) - 1)
    cs = (np.exp(theta_b * cs) - 1) / (1 - np.exp(-theta_b))
    lon, lat = inverse(*rho, origin)
    u = np.empty((len(seconds), count) + at_u[0].shape)
    v = np.empty((len(seconds), count) + at_v[0].shape)
    w = np.zeros((len(seconds), count + 1) + rho[0].shape)
    surface = np.array([zeta(*rho, t) * np.ones_like(rho[0]) for t in seconds])
    depth = h(*rho) * np.ones_like(rho[0])
    heights = np.array([levels_of(s, cs, hc, transform, depth, one) for one in surface])
    d = 1e-5

    def scale(x, y):
        """Lengths on the map over those on earth, and the angle of the map's x axis from east."""
        a, b = inverse(x, y, origin)
        along = radii(b)[0]
        east = (to_map(a + d, b, origin) - to_map(a - d, b, origin)) / (2 * np.radians(d) * along)
        return np.hypot(*east), np.arctan2(east[1], east[0])

    for n, t in enumerate(seconds):
        for k in range(count):
            for to, at, axis_of in ((u, at_u, (cos, sin)), (v, at_v, (-sin, cos))):
                here = levels_of(s, cs, hc, transform, h(*at) * np.ones_like(at[0]), zeta(*at, t) * np.ones_like(at[0]))
                fx, fy = flow(*at, here[k], t)
                to[n, k] = (axis_of[0] * fx + axis_of[1] * fy) / scale(*at)[0]
    dimensions = {"ocean_time": len(seconds), "s_rho": count, "s_w": count + 1, "eta_rho": rows, "xi_rho": columns,
                  "eta_u": rows, "xi_u": columns - 1, "eta_v": rows - 1, "xi_v": columns}
    standard = f"ocean_s_coordinate_g{transform}"
    variables = {
        "ocean_time": Variable("ocean_time", np.asarray(seconds, float), "f8", units="seconds since 2020-01-01"),
        "s_rho": Variable("s_rho", s, "f8", standard_name=standard, positive="up",
                          formula_terms="s: s_rho C: Cs_r eta: zeta depth: h depth_c: hc"),
        "Cs_r": Variable("s_rho", cs, "f8"), "hc": Variable("", np.array(hc), "f8", units="meter"),
        "Vtransform": Variable("", np.array(transform), "i4"), "Vstretching": Variable("", np.array(4), "i4"),
        "theta_s": Variable("", np.array(theta_s), "f8"), "theta_b": Variable("", np.array(theta_b), "f8"),
        "h": Variable("eta_rho xi_rho", depth, "f8", units="meter"),
        "zeta": Variable("ocean_time eta_rho xi_rho", surface, "f8", units="meter"),
        "lon_rho": Variable("eta_rho xi_rho", lon, "f8", **EAST),
        "lat_rho": Variable("eta_rho xi_rho", lat, "f8", **NORTH),
        "angle": Variable("eta_rho xi_rho", turn - scale(*rho)[1], "f8", units="radians"),
        "u": Variable("ocean_time s_rho eta_u xi_u", u, "f8", units="meter second-1"),
        "v": Variable("ocean_time s_rho eta_v xi_v", v, "f8", units="meter second-1"),
        "w": Variable("ocean_time s_w eta_rho xi_rho", w, "f8", units="meter second-1")}
    if land is not None:
        variables["mask_rho"] = Variable("eta_rho xi_rho", np.where(land, 0.0, 1.0), "f8")
    for name in drop:
        variables.pop(name)
    for name, one in more.items():
        variables[name] = one
    write(path, dimensions, variables, unlimited="ocean_time")
    inner = np.s_[1:-1, 1:-1]
    return rho[0][inner], rho[1][inner], heights[(slice(None), slice(None)) + inner]


def mesh(path, flow, origin, size, seconds, depth, zeta, kind="fvcom", levels=4):
    """A mesh of triangles over a square of 2 size [m] with velocities in faces (FVCOM) or at nodes (UGRID)."""
    random = np.random.default_rng(3)
    side = 9
    i, j = np.meshgrid(np.arange(side), np.arange(side))
    inner = (i > 0) & (i < side - 1) & (j > 0) & (j < side - 1)
    x = ((i + 0.25 * inner * random.uniform(-1, 1, i.shape)) / (side - 1) * 2 - 1).ravel() * size
    y = ((j + 0.25 * inner * random.uniform(-1, 1, i.shape)) / (side - 1) * 2 - 1).ravel() * size
    first = (j * side + i)[:-1, :-1].ravel()
    faces = np.concatenate([np.stack([first, first + side, first + 1], 1),  # clockwise, as those of FVCOM
                            np.stack([first + 1, first + side, first + side + 1], 1)])
    lon, lat = inverse(x, y, origin)
    centers = x[faces].mean(1), y[faces].mean(1)
    at = centers if kind == "fvcom" else (x, y)
    place = inverse(*at, origin)
    sigma = -(np.arange(levels) + 0.5) / levels  # from the surface downwards
    u = np.empty((len(seconds), levels, at[0].size))
    v = np.empty_like(u)
    for n, t in enumerate(seconds):
        for k in range(levels):
            z = zeta + sigma[k] * (depth + zeta)
            u[n, k], v[n, k] = on_earth(*place, origin, lambda a, b: flow(a, b, z, t))
    if kind == "fvcom":
        days = np.asarray(seconds) // 86400
        dimensions = {"time": len(seconds), "siglay": levels, "node": x.size, "nele": len(faces), "three": 3}
        variables = {
            "time": Variable("time", np.asarray(seconds) / 86400 + 58849.0, "f4",
                             units="days since 1858-11-17 00:00:00"),
            "Itime": Variable("time", days + 58849, "i4", units="days since 1858-11-17 00:00:00"),
            "Itime2": Variable("time", (np.asarray(seconds) - 86400 * days) * 1000, "i4", units="msec since 00:00:00"),
            "siglay": Variable("siglay node", np.repeat(sigma[:, None], x.size, 1), "f8",
                               standard_name="ocean_sigma_coordinate", positive="up",
                               formula_terms="sigma: siglay eta: zeta depth: h"),
            "h": Variable("node", np.full(x.size, depth), "f8", units="m"),
            "zeta": Variable("time node", np.full((len(seconds), x.size), zeta), "f8", units="meters"),
            "lon": Variable("node", lon, "f8", **EAST), "lat": Variable("node", lat, "f8", **NORTH),
            "nv": Variable("three nele", faces.T + 1, "i4"),
            "u": Variable("time siglay nele", u, "f8", units="meters s-1"),
            "v": Variable("time siglay nele", v, "f8", units="meters s-1")}
    else:
        dimensions = {"time": len(seconds), "node": x.size, "face": len(faces), "three": 3}
        variables = {
            "Mesh2": Variable("", np.array(0), "i4", cf_role="mesh_topology", topology_dimension=np.array(2, "i4"),
                              node_coordinates="Mesh2_x Mesh2_y", face_node_connectivity="Mesh2_faces"),
            "Mesh2_faces": Variable("face three", faces, "i4", start_index=np.array(0, "i4")),
            "Mesh2_x": Variable("node", lon, "f8", **EAST), "Mesh2_y": Variable("node", lat, "f8", **NORTH),
            "time": times(seconds),
            "ue": Variable("time node", u[:, 0], "f8", standard_name="eastward_sea_water_velocity", units="m/s",
                           mesh="Mesh2", location="node"),
            "un": Variable("time node", v[:, 0], "f8", standard_name="northward_sea_water_velocity", units="m/s",
                           mesh="Mesh2", location="node")}
    write(path, dimensions, variables)
    return x, y, faces
