package org.pendant.motion.toolpath.nc;

import java.util.List;

/**
 * Toolpath: the content of a toolpath file.
 *
 * @param file its name, for messages
 * @param points in their order, at least one
 * @param ignored codes that were read and have no effect here, each once
 */
public record NcPath(String file, List<NcPoint> points, List<String> ignored) {
  /** Copies the lists. */
  public NcPath {
    points = List.copyOf(points);
    ignored = List.copyOf(ignored);
  }
}
