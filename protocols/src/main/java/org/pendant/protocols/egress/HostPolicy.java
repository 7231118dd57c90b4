package org.pendant.protocols.egress;

import static org.pendant.protocols.egress.EgressTexts.text;

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
 * Host policy: connects to other computers where they are allowed. It checks the address that it
 * connects to, so a name that changes its address in between gains nothing.
 *
 * @param allowed where it may go
 * @param names who knows the addresses of names; asked for those only that are allowed
 * @param traced what is told of its connections
 */
public record HostPolicy(AllowedHosts allowed, Names names, Traced traced) {
  /** This computer; its name needs no asking (RFC 6761, section 6.3). */
  private static final String LOCALHOST = "localhost";

  private static final List<String> LOOPBACK = List.of("127.0.0.1", "::1");

  /** Tells the addresses of a name. */
  @FunctionalInterface
  public interface Names {
    /**
     * All addresses of a host.
     *
     * @throws UnknownHostException if it has none
     */
    InetAddress[] addresses(String host) throws UnknownHostException;
  }

  /** Asks as this computer is set up to: its list of hosts, then mostly the DNS. */
  public HostPolicy(AllowedHosts allowed) {
    this(allowed, InetAddress::getAllByName);
  }

  /** Without a trace. */
  public HostPolicy(AllowedHosts allowed, Names names) {
    this(allowed, names, Traced.NOT);
  }

  /** The same, with connections that are traced. */
  public HostPolicy with(Traced wanted) {
    return new HostPolicy(allowed, names, wanted);
  }

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
    IOException failure = new ConnectException(text("noAddress"));
    for (InetAddress address : addresses) {
      TracedSocket socket = new TracedSocket(traced);
      try {
        socket.setTcpNoDelay(true);
        socket.connect(new InetSocketAddress(address, port), timeoutMs);
        socket.opened();
        return socket;
      } catch (SocketTimeoutException e) {
        failure = new SocketTimeoutException(text("noAnswerWithin", timeoutMs / 1000.0));
      } catch (ConnectException e) {
        failure = new ConnectException(text("connectionRefused"));
      } catch (IOException e) {
        failure = e;
      }
      socket.close();
    }
    throw failure;
  }

  private List<InetAddress> addresses(String host) throws IOException {
    if (AllowedHosts.isLiteral(host)) {
      return List.of(InetAddress.ofLiteral(host));
    }
    if (host.equalsIgnoreCase(LOCALHOST)) {
      return LOOPBACK.stream().map(InetAddress::ofLiteral).toList();
    }
    if (host.isBlank()) {
      // for Java that would be this computer
      throw new UnknownHostException(text("noSuchHost"));
    }
    if (!allowed.mayAskFor(host)) {
      throw new HostNotAllowed();
    }
    // a look-up holds the thread it runs on, and there are few for all virtual ones
    FutureTask<InetAddress[]> lookup = new FutureTask<>(() -> names.addresses(host));
    Thread.ofPlatform().daemon().name("look-up of " + host).start(lookup);
    try {
      return Arrays.asList(lookup.get());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(text("givenUp"), e);
    } catch (ExecutionException e) {
      UnknownHostException unknown = new UnknownHostException(text("noSuchHost"));
      unknown.initCause(e.getCause());
      throw unknown;
    }
  }
}
