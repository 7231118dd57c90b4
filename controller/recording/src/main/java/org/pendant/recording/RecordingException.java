package org.pendant.recording;

import java.io.IOException;

/**
 * Recording error: a file that is no recording, of another version, or damaged; the message says
 * which.
 */
public final class RecordingException extends IOException {
  private static final long serialVersionUID = 1L;

  RecordingException(String message) {
    super(message);
  }
}
