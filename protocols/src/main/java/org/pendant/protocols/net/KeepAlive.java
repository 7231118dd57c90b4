package org.pendant.protocols.net;

import java.io.IOException;
import java.net.SocketOption;
import java.net.StandardSocketOptions;
import java.nio.channels.SocketChannel;
import jdk.net.ExtendedSocketOptions;

/** Keep-alive: lets the system find out that a peer's computer is gone, which no packet says. */
final class KeepAlive {
  private static final int FIRST_AFTER_S = 60;
  private static final int INTERVAL_S = 10;
  private static final int TIMES = 3;

  private KeepAlive() {}

  /** Has a silent peer asked whether it is there; after 90 s without an answer it is gone. */
  static void set(SocketChannel channel) throws IOException {
    channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
    setIfKnown(channel, ExtendedSocketOptions.TCP_KEEPIDLE, FIRST_AFTER_S);
    setIfKnown(channel, ExtendedSocketOptions.TCP_KEEPINTERVAL, INTERVAL_S);
    setIfKnown(channel, ExtendedSocketOptions.TCP_KEEPCOUNT, TIMES);
  }

  private static void setIfKnown(SocketChannel channel, SocketOption<Integer> option, int value)
      throws IOException {
    if (channel.supportedOptions().contains(option)) {
      channel.setOption(option, value);
    }
  }
}
