package org.pendant.protocols.server;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;

/** Test of a port: whether this process may not use it, or another process does. */
public final class PrivilegedPort {
  /** From here on every user may use a port. */
  private static final int FIRST_FREE = 1024;

  private PrivilegedPort() {}

  /** Whether the system forbids this process the port that stands for {@code standardPort}. */
  public static boolean forbidden(PortNumbers numbers, int standardPort) {
    int number = numbers.listening("", standardPort).port();
    return number < FIRST_FREE
        && !canBeBound(numbers.host(), number)
        && !answers(numbers.host(), number);
  }

  private static boolean canBeBound(InetAddress host, int number) {
    try (ServerSocketChannel probe = ServerSocketChannel.open()) {
      probe.bind(new InetSocketAddress(host, number));
      return true;
    } catch (BindException e) {
      return false;
    } catch (IOException e) {
      // whatever this is, opening the port in earnest will say it
      return true;
    }
  }

  private static boolean answers(InetAddress host, int number) {
    try (SocketChannel probe = SocketChannel.open()) {
      return probe.connect(new InetSocketAddress(host, number));
    } catch (IOException e) {
      return false;
    }
  }
}
