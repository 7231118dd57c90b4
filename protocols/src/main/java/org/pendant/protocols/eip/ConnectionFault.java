package org.pendant.protocols.eip;

/**
 * Connection fault: why a connection is not opened or closed: extended status (CIP volume 1, table
 * 3-5.29).
 */
enum ConnectionFault {
  DUPLICATE(0x0100),
  TRANSPORT(0x0103),
  OWNERSHIP(0x0106),
  NOT_FOUND(0x0107),
  TYPE(0x0108),
  RPI(0x0111),
  NO_MORE(0x0113),
  WRONG_VENDOR_OR_PRODUCT(0x0114),
  WRONG_DEVICE_TYPE(0x0115),
  WRONG_REVISION(0x0116),
  PATH(0x0117),
  VARIABLE_SIZE_TO_TARGET(0x011F),
  VARIABLE_SIZE_TO_ORIGINATOR(0x0120),
  CONFIGURATION_SIZE(0x0126),
  SIZE_TO_TARGET(0x0127),
  SIZE_TO_ORIGINATOR(0x0128);

  private final int code;

  ConnectionFault(int code) {
    this.code = code;
  }

  int code() {
    return code;
  }
}
