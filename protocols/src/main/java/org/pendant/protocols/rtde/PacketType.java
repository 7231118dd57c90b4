package org.pendant.protocols.rtde;

/** Packet types: the letters that say what a package is, the same in both directions. */
final class PacketType {
  static final int PROTOCOL_VERSION = 'V';
  static final int CONTROLLER_VERSION = 'v';
  static final int TEXT_MESSAGE = 'M';
  static final int DATA = 'U';
  static final int SETUP_OUTPUTS = 'O';
  static final int SETUP_INPUTS = 'I';
  static final int START = 'S';
  static final int PAUSE = 'P';

  private PacketType() {}
}
