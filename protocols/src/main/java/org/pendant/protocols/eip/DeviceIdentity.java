package org.pendant.protocols.eip;

import org.pendant.controller.state.SoftwareVersion;

/**
 * Device identity: what the adapter says that it is (CIP volume 1, 5-2).
 *
 * @param major of the revision
 * @param minor of the revision
 */
record DeviceIdentity(
    int vendor, int deviceType, int productCode, int major, int minor, int serial, String name) {
  /** Every box of ours; docs/protocols/ethernet-ip.md has the reasons. */
  static final DeviceIdentity OWN =
      new DeviceIdentity(
          1399,
          0x2B,
          1,
          SoftwareVersion.REPORTED.major(),
          SoftwareVersion.REPORTED.minor(),
          0x2022_5500,
          "Universal Robots");
}
