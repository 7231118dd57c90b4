package org.pendant.recording.compare;

/** A text that is no track of a run, or one that this version does not read; says why. */
public final class MalformedTrack extends Exception {
  private static final long serialVersionUID = 1L;

  MalformedTrack(String why) {
    super(why, null, false, false);
  }
}
