package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.ReceivedBytes;
import org.pendant.controller.external.SocketConnector;

/** Peers of a test, by their ports; a program that connects anywhere else is refused. */
public final class TestPeers implements SocketConnector {
  private final Map<Integer, Peer> byPort = new TreeMap<>();
  private long frame;

  TestPeers() {}

  @Override
  public ExternalSocket open(String host, int port) {
    Peer peer = byPort.get(port);
    return peer == null ? new Nobody(host, port, new ReceivedBytes()) : peer.connect();
  }

  /** Begins to listen at a port; a peer that does so already stays as it is. */
  public Peer listen(int port) {
    return byPort.computeIfAbsent(port, each -> new Peer(this, each));
  }

  /** The peer at a port. */
  public Optional<Peer> at(int port) {
    return Optional.ofNullable(byPort.get(port));
  }

  /** Has what is due arrive, once a frame. */
  public void step(long now) {
    frame = now;
    byPort.values().forEach(Peer::step);
  }

  long frame() {
    return frame;
  }

  /** A connection to where nobody listens. */
  private record Nobody(String host, int port, ReceivedBytes received) implements ExternalSocket {
    @Override
    public Stage stage() {
      return Stage.FAILED;
    }

    @Override
    public String failure() {
      return text("noPeer", port, port);
    }

    @Override
    public boolean send(byte[] bytes) {
      return false;
    }

    @Override
    public void close() {}
  }
}
