package org.pendant.protocols;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.external.Connectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;
import org.pendant.protocols.egress.Traced;
import org.pendant.protocols.http.HttpDissector;
import org.pendant.protocols.modbus.ModbusDissector;
import org.pendant.protocols.modbusclient.ModbusClients;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.socket.ScriptSockets;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.ReversedDissector;
import org.pendant.protocols.xmlrpc.XmlRpcConnector;

/** Connectors of one controller's scripts: sockets, remote procedure calls and Modbus devices. */
public final class ScriptConnectors implements AutoCloseable {
  private final ScriptSockets sockets;
  private final XmlRpcConnector servers;
  private final ModbusClients devices;
  private final Connectors connectors;
  private volatile Optional<WireTap> tap = Optional.empty();

  /** Ways to {@code allowed} computers. */
  public ScriptConnectors(AllowedHosts allowed) {
    HostPolicy hostPolicy = new HostPolicy(allowed);
    sockets = new ScriptSockets(hostPolicy.with(traced("Script socket", Dissector::raw)));
    servers =
        new XmlRpcConnector(
            hostPolicy.with(traced("XML-RPC", () -> new ReversedDissector(new HttpDissector()))));
    devices =
        new ModbusClients(
            hostPolicy.with(
                traced("Modbus client", () -> new ReversedDissector(new ModbusDissector()))));
    connectors = new Connectors(sockets, servers, devices);
  }

  private Traced traced(String name, Supplier<Dissector> dissector) {
    return new Traced(name, dissector, () -> tap);
  }

  /**
   * Has {@code listener} hear from now on what goes over connections that programs make; empty for
   * nobody.
   */
  public void tap(Optional<WireTap> listener) {
    tap = listener;
  }

  /** For the options of the controller. */
  public Connectors connectors() {
    return connectors;
  }

  /** Closes what programs have left open; waits for their last bytes, a few seconds at most. */
  @Override
  public void close() {
    devices.close();
    servers.close();
    sockets.close();
  }
}
