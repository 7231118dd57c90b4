package org.pendant.protocols;

import org.pendant.controller.external.Connectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;
import org.pendant.protocols.modbusclient.ModbusClients;
import org.pendant.protocols.socket.ScriptSockets;
import org.pendant.protocols.xmlrpc.XmlRpcConnector;

/** Connectors of one controller's scripts: sockets, remote procedure calls and Modbus devices. */
public final class ScriptConnectors implements AutoCloseable {
  private final ScriptSockets sockets;
  private final XmlRpcConnector servers;
  private final ModbusClients devices;
  private final Connectors connectors;

  /** Ways to {@code allowed} computers. */
  public ScriptConnectors(AllowedHosts allowed) {
    HostPolicy hostPolicy = new HostPolicy(allowed);
    sockets = new ScriptSockets(hostPolicy);
    servers = new XmlRpcConnector(hostPolicy);
    devices = new ModbusClients(hostPolicy);
    connectors = new Connectors(sockets, servers, devices);
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
