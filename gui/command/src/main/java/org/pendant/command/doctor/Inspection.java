package org.pendant.command.doctor;

import java.util.List;

/**
 * Inspection: looks at one part of this computer. What the desktop looks at is a service of this
 * type.
 */
@FunctionalInterface
public interface Inspection {
  /** What there is, in the order in which people read it. It changes nothing on the computer. */
  List<Finding> findings();
}
