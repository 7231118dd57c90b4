package org.pendant.command.doctor;

/** What this package says to people. */
final class DoctorTexts {
  private static final FindingTexts TEXTS = FindingTexts.of(DoctorTexts.class);

  private DoctorTexts() {}

  /** The text of a key of {@code texts/command.doctor.properties}, filled with values. */
  static FindingText text(String key, Object... values) {
    return TEXTS.get(key, values);
  }
}
