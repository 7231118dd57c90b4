package org.pendant.protocols.net;

/**
 * Silence of a peer: how it is silent.
 *
 * @param lastsNs for how long, ns
 */
record Silence(Kind kind, long lastsNs) {

  /** From the silence that tells least of a peer that is still there. */
  enum Kind {
    /** What is sent to it waits, and it takes nothing of it. */
    NOT_READING,
    /** Nothing has come from it since it connected. */
    NEVER_SPOKEN,
    /** Neither has anything come from it lately, nor has it been sent anything. */
    SPOKEN
  }
}
