package org.pendant.recording.replay;

/**
 * Rerun refusal: a run cannot be repeated up to the frame that was asked for; the message says why,
 * for people.
 */
public final class RerunRefused extends Exception {
  private static final long serialVersionUID = 1;

  /** Refused for a reason. */
  public RerunRefused(String message) {
    super(message);
  }
}
