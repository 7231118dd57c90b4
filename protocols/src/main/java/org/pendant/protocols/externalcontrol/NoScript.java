package org.pendant.protocols.externalcontrol;

/**
 * Missing script: a driver has sent none; the message says which should have, and what is wrong.
 */
public final class NoScript extends Exception {
  private static final long serialVersionUID = 1L;

  NoScript(String message) {
    super(message);
  }
}
