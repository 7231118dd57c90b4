package org.pendant.language.service;

import java.util.List;
import org.pendant.language.source.SourceRange;

/**
 * Written pose: a pose of six numbers as it stands in the text.
 *
 * @param range the whole {@code p[...]}
 * @param elements x, y, z in m, then the rotation vector rx, ry, rz in rad
 */
public record WrittenPose(SourceRange range, List<Double> elements) {

  /** Copies the elements. */
  public WrittenPose {
    elements = List.copyOf(elements);
  }
}
