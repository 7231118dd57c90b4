package org.pendant.desktop.program.form;

import java.util.List;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.Pattern;

/** Sketch: what a picture in a form shows. */
sealed interface Sketch {

  /** The corners of a pattern with its places. */
  record Places(Pattern pattern) implements Sketch {}

  /** A direction in a frame. */
  record Arrow(double x, double y, double z) implements Sketch {}

  /** A stack that is searched along a direction. */
  record Stack(boolean destack, double x, double y, double z) implements Sketch {}

  /** A frame with those of its six axes marked that give way. */
  record Axes(List<Boolean> compliant, List<Double> wrench) implements Sketch {
    public Axes {
      compliant = List.copyOf(compliant);
      wrench = List.copyOf(wrench);
    }
  }

  /** A popup as operators will see it. */
  record Message(String text, ActionStep.PopupKind kind, boolean halts) implements Sketch {}
}
