package org.pendant.protocols.eip;

import java.util.List;

/**
 * CIP refusal: a request is not carried out; the answer tells why in numbers (CIP volume 1,
 * appendix B).
 */
final class CipRefusal extends Exception {
  /** Something about a connection; the first extended word says what. */
  static final int CONNECTION = 0x01;

  static final int PATH_SEGMENT = 0x04;
  static final int UNKNOWN_PATH = 0x05;
  static final int UNKNOWN_SERVICE = 0x08;
  static final int NOT_SETTABLE = 0x0E;
  static final int REPLY_TOO_LARGE = 0x11;
  static final int TOO_SHORT = 0x13;
  static final int UNKNOWN_ATTRIBUTE = 0x14;
  static final int TOO_LONG = 0x15;
  static final int UNKNOWN_OBJECT = 0x16;

  private static final long serialVersionUID = 1L;

  private final int status;
  private final transient List<Integer> extended;

  CipRefusal(int status, Integer... extended) {
    super("status " + status);
    this.status = status;
    this.extended = List.of(extended);
  }

  /** About a connection. */
  static CipRefusal connection(ConnectionFault fault, Integer... more) {
    Integer[] words = new Integer[more.length + 1];
    words[0] = fault.code();
    System.arraycopy(more, 0, words, 1, more.length);
    return new CipRefusal(CONNECTION, words);
  }

  int status() {
    return status;
  }

  /** Further words, 16 bits each. */
  List<Integer> extended() {
    return extended;
  }
}
