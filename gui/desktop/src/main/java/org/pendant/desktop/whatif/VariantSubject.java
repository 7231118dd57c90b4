package org.pendant.desktop.whatif;

import java.util.Optional;
import org.pendant.desktop.session.ProgramDocument;

/**
 * Variant subject: the program that variants are of.
 *
 * @param ran the one that ran; empty where it is none that is open, such as one from a port
 * @param front the one in front of which people had the variants run
 */
record VariantSubject(Optional<ProgramDocument> ran, ProgramDocument front) {
  /** Whether the variants are to be seen in 3D while people look at a program. */
  boolean seenWith(ProgramDocument now) {
    return front == now || ran.filter(each -> each == now).isPresent();
  }

  /** What it is called. */
  String name() {
    return ran.orElse(front).name();
  }
}
