package org.pendant.controller.bench;

import java.util.Optional;

/** Expected trouble: what would make a test red if the test had not said that it wants it. */
public final class Expected {
  private Optional<String> failure = Optional.empty();
  private boolean safetyStop;
  private boolean programFailure;

  Expected() {}

  /** From now on the test has to end with an error whose message contains {@code part}. */
  public void failure(String part) {
    failure = Optional.of(part);
  }

  /** What the error has to contain with which the test has to end. */
  public Optional<String> failure() {
    return failure;
  }

  /** The test knows of stops by the safety functions. */
  public void safetyStop() {
    safetyStop = true;
  }

  /** Whether the test knows of stops by the safety functions. */
  public boolean knowsSafetyStop() {
    return safetyStop;
  }

  /** The test has asked how the program ended. */
  public void programFailure() {
    programFailure = true;
  }

  /** Whether the test knows that a program may have failed. */
  public boolean knowsProgramFailure() {
    return programFailure;
  }
}
