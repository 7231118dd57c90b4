package org.pendant.protocols.eip;

import java.util.Optional;

/**
 * Electronic key: what a scanner expects to be connected to; zero stands for any device (CIP volume
 * 1, C-1.4.5.2).
 *
 * @param compatible whether an older device that this one can stand for is right as well
 */
record ElectronicKey(
    int vendor, int deviceType, int productCode, boolean compatible, int major, int minor) {

  /** What is wrong with a device; empty when it is the right one. */
  Optional<ConnectionFault> mismatch(DeviceIdentity device) {
    if ((vendor != 0 && vendor != device.vendor())
        || (productCode != 0 && productCode != device.productCode())) {
      return Optional.of(ConnectionFault.WRONG_VENDOR_OR_PRODUCT);
    }
    if (deviceType != 0 && deviceType != device.deviceType()) {
      return Optional.of(ConnectionFault.WRONG_DEVICE_TYPE);
    }
    boolean minorFits =
        minor == 0 || (compatible ? minor <= device.minor() : minor == device.minor());
    return major == 0 || (major == device.major() && minorFits)
        ? Optional.empty()
        : Optional.of(ConnectionFault.WRONG_REVISION);
  }
}
