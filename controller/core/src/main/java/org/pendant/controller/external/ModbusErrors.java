package org.pendant.controller.external;

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
      case 0 -> "connected";
      case DISCONNECTED -> "not connected";
      case NETWORK -> "network error";
      case NOT_ALLOWED -> "not among the allowed hosts";
      case PROTOCOL -> "the answer is no Modbus";
      case RESET -> "connection reset";
      case NO_ANSWER -> "no answer";
      case REFUSED -> "connection refused";
      case NO_HOST -> "no such host, or no way to it";
      default -> "connection error " + error;
    };
  }

  /** What an error of the device is. */
  public static String device(int error) {
    String words =
        switch (error) {
          case 0 -> "none";
          case 1 -> "illegal function code";
          case 2 -> "illegal data access";
          case 3 -> "illegal data value";
          case 4 -> "server failure";
          case 5 -> "acknowledge exception";
          case 6 -> "server busy";
          case 10 -> "gateway problem";
          case 11 -> "gateway target failure";
          default -> "unknown";
        };
    return "device error " + error + ", " + words;
  }

  /** What is wrong with a signal; empty when it is valid. */
  public static String of(ModbusReading reading) {
    if (reading.connectionError() != 0) {
      return connection(reading.connectionError());
    }
    return reading.deviceError() == 0 ? "" : device(reading.deviceError());
  }
}
