package org.pendant.controller.external;

import org.pendant.script.value.ScriptError;

/** Connector to Modbus devices. No method waits. */
public interface ModbusConnector {
  /** No way to any device. */
  ModbusConnector NONE =
      new ModbusConnector() {
        @Override
        public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
          throw Connectors.missing();
        }

        @Override
        public Pending send(ModbusAddress device, int unit, int function, byte[] data)
            throws ScriptError {
          throw Connectors.missing();
        }
      };

  /**
   * Begins to read or write something, 10 times a second.
   *
   * @throws ScriptError when this controller cannot connect to anything
   */
  ModbusPoint add(ModbusExchange exchange) throws ScriptError;

  /**
   * Sends a request that was made elsewhere; over when the device has had the time to answer it.
   *
   * @param unit 0 to 255
   * @param function 1 to 127
   * @param data what follows the function, at most 252 bytes
   * @throws ScriptError when this controller cannot connect to anything
   */
  Pending send(ModbusAddress device, int unit, int function, byte[] data) throws ScriptError;
}
