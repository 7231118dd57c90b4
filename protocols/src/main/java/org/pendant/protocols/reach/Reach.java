package org.pendant.protocols.reach;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * Connects to other computers, if they are allowed. It looks at the very address that it connects
 * to, so a name that changes its address in between gains nothing.
 *
 * @param allowed where it may go
 */
public record Reach(AllowedHosts allowed) {

  /**
   * Connects, and waits for that; an interrupted virtual thread gives up.
   *
   * @param host a name or an address
   * @param timeoutMs for each address of the host
   * @throws IOException when that fails; the message says why, without the host
   */
  public Socket connect(String host, int port, int timeoutMs) throws IOException {
    List<InetAddress> addresses =
        addresses(host).stream().filter(address -> allowed.allows(host, address)).toList();
    if (addresses.isEmpty()) {
      throw new HostNotAllowed();
    }
    IOException failure = new ConnectException("no address");
    for (InetAddress address : addresses) {
      Socket socket = new Socket();
      try {
        socket.setTcpNoDelay(true);
        socket.connect(new InetSocketAddress(address, port), timeoutMs);
        return socket;
      } catch (SocketTimeoutException e) {
        failure = new SocketTimeoutException("no answer within " + timeoutMs / 1000.0 + " s");
      } catch (ConnectException e) {
        failure = new ConnectException("connection refused");
      } catch (IOException e) {
        failure = e;
      }
      socket.close();
    }
    throw failure;
  }

  private static List<InetAddress> addresses(String host) throws IOException {
    if (AllowedHosts.isLiteral(host)) {
      return List.of(InetAddress.ofLiteral(host));
    }
    if (host.isBlank()) {
      // for Java that would be this computer
      throw new UnknownHostException("no such host");
    }
    // a look-up holds the thread it runs on, and there are few for all virtual ones
    FutureTask<InetAddress[]> lookup = new FutureTask<>(() -> InetAddress.getAllByName(host));
    Thread.ofPlatform().daemon().name("look-up of " + host).start(lookup);
    try {
      return Arrays.asList(lookup.get());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("given up", e);
    } catch (ExecutionException e) {
      UnknownHostException unknown = new UnknownHostException("no such host");
      unknown.initCause(e.getCause());
      throw unknown;
    }
  }
}
