package org.pendant.protocols.modbusclient;

import java.util.List;

/** Device response: what a device answers to a request. */
sealed interface DeviceResponse {
  /**
   * What was read.
   *
   * @param values bits as 0 and 1, registers 0 to 65535
   */
  record Values(List<Integer> values) implements DeviceResponse {}

  /** It has done what it was told. */
  record Done() implements DeviceResponse {}

  /**
   * It will not.
   *
   * @param code the exception code, 1 to 255
   */
  record Refused(int code) implements DeviceResponse {}

  /** It says something that is no answer to this question. */
  record Nonsense() implements DeviceResponse {}
}
