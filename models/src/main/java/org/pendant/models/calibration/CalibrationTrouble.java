package org.pendant.models.calibration;

import org.pendant.models.json.FilePosition;

/**
 * Calibration error: a file is no calibration of the arm. The message says where, what was found
 * there and what would be right. Carries no stack trace, it is no fault of the program.
 */
public final class CalibrationTrouble extends Exception {
  private static final long serialVersionUID = 1L;

  /** What is wrong, with the name of the file in front. */
  public CalibrationTrouble(String message) {
    super(message, null, false, false);
  }

  static CalibrationTrouble at(FilePosition place, String message) {
    return new CalibrationTrouble(
        place.file() + ":" + place.line() + ":" + place.column() + ": " + message);
  }
}
