package org.pendant.controller.external;

import static org.pendant.controller.external.ExternalTexts.text;

/** Modbus errors: why a signal is not valid, as numbers (manual 18.27) and in words. */
public final class ModbusErrors {
  /** Not connected yet, or closed by the device. */
  public static final int DISCONNECTED = -2;

  /** Something went wrong with the network: EIO. */
  public static final int NETWORK = 5;

  /** A device that must not be reached: EACCES. */
  public static final int NOT_ALLOWED = 13;

  /** The device does not speak Modbus: EPROTO. */
  public static final int PROTOCOL = 71;

  /** The device has broken the connection: ECONNRESET. */
  public static final int RESET = 104;

  /** No answer in time: ETIMEDOUT. */
  public static final int NO_ANSWER = 110;

  /** No server listens there: ECONNREFUSED. */
  public static final int REFUSED = 111;

  /** There is no such host, or no way to it: EHOSTUNREACH. */
  public static final int NO_HOST = 113;

  private ModbusErrors() {}

  /** What an error of the connection is. */
  public static String connection(int error) {
    return switch (error) {
      case 0 -> text("connected");
      case DISCONNECTED -> text("notConnected");
      case NETWORK -> text("networkError");
      case NOT_ALLOWED -> text("hostNotAllowed");
      case PROTOCOL -> text("noModbus");
      case RESET -> text("connectionReset");
      case NO_ANSWER -> text("noAnswer");
      case REFUSED -> text("connectionRefused");
      case NO_HOST -> text("noHost");
      default -> text("connectionError", error);
    };
  }

  /** What an error of the device is. */
  public static String device(int error) {
    return switch (error) {
      case 0 -> text("noDeviceError", error);
      case 1 -> deviceError(error, text("illegalFunction"));
      case 2 -> deviceError(error, text("illegalAccess"));
      case 3 -> deviceError(error, text("illegalValue"));
      case 4 -> deviceError(error, text("serverFailure"));
      case 5 -> deviceError(error, text("acknowledge"));
      case 6 -> deviceError(error, text("serverBusy"));
      case 10 -> deviceError(error, text("gatewayProblem"));
      case 11 -> deviceError(error, text("gatewayTarget"));
      default -> text("unknownDeviceError", error);
    };
  }

  private static String deviceError(int error, String words) {
    return text("deviceError", error, words);
  }

  /** What is wrong with a signal; empty when it is valid. */
  public static String of(ModbusReading reading) {
    if (reading.connectionError() != 0) {
      return connection(reading.connectionError());
    }
    return reading.deviceError() == 0 ? "" : device(reading.deviceError());
  }
}
