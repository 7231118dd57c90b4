package org.pendant.testing.remote;

/** Sent text: a program as ports take it, and where its lines come from. */
public interface SentText {
  /** What is sent: one {@code def} from the first column on; bytes, one {@code char} a byte. */
  String text();

  /** The line of the source that a line of the text is; 0 for one that is in no source. */
  int lineOf(int sent);

  /** The column in the source of a column in a line of the text. */
  int columnOf(int sent, int column);
}
