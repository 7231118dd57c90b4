package org.pendant.command.doctor;

/** Findings that say the same in every language. */
public final class PlainFindings {
  private PlainFindings() {}

  /** All is well. */
  public static Finding ok(String subject, String found) {
    return Finding.ok(FindingText.of(subject), FindingText.of(found));
  }

  /** Something is missing that not everybody needs. */
  public static Finding note(String subject, String found, String advice) {
    return Finding.note(FindingText.of(subject), FindingText.of(found), FindingText.of(advice));
  }

  /** Something does not work until it is mended. */
  public static Finding problem(String subject, String found, String advice) {
    return Finding.problem(FindingText.of(subject), FindingText.of(found), FindingText.of(advice));
  }
}
