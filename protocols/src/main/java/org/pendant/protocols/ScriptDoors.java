package org.pendant.protocols;

import org.pendant.controller.outside.Doors;
import org.pendant.protocols.modbusclient.ModbusClients;
import org.pendant.protocols.reach.AllowedHosts;
import org.pendant.protocols.reach.Reach;
import org.pendant.protocols.socket.ScriptSockets;
import org.pendant.protocols.xmlrpc.XmlRpcDoor;

/**
 * The ways out of one controller: sockets, remote procedure calls and Modbus devices of its
 * scripts.
 */
public final class ScriptDoors implements AutoCloseable {
  private final ScriptSockets sockets;
  private final XmlRpcDoor servers;
  private final ModbusClients devices;
  private final Doors doors;

  /** Ways to {@code allowed} computers. */
  public ScriptDoors(AllowedHosts allowed) {
    Reach reach = new Reach(allowed);
    sockets = new ScriptSockets(reach);
    servers = new XmlRpcDoor(reach);
    devices = new ModbusClients(reach);
    doors = new Doors(sockets, servers, devices);
  }

  /** For the options of the controller. */
  public Doors doors() {
    return doors;
  }

  /** Closes what programs have left open; waits for their last bytes, a few seconds at most. */
  @Override
  public void close() {
    devices.close();
    servers.close();
    sockets.close();
  }
}
