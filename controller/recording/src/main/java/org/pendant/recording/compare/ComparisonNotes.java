package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

/** Comparison notes: what people should know who read the figures of a comparison. */
public final class ComparisonNotes {
  private ComparisonNotes() {}

  /** The arm moved already when the recording began. */
  public static String beginsInMotion() {
    return text("startedBeforeMotion");
  }

  /** The recording has a payload, but not where its centre of gravity was. */
  public static String unknownCentreOfGravity() {
    return text("unknownCentreOfGravity");
  }

  /** The recording has joint positions alone. */
  public static String speedsFromPositions() {
    return text("speedsFromPositions");
  }
}
