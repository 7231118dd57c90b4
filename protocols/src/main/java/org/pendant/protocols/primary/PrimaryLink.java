package org.pendant.protocols.primary;

import static org.pendant.protocols.primary.PrimaryTexts.text;

import java.io.Closeable;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Primary link: sends programs to the primary port of a controller, of Pendant's or of a real
 * robot, and hears its messages and variables. One thread uses it; another one of its own reads.
 */
public final class PrimaryLink implements Closeable {
  private static final int HEADER_BYTES = 5;
  private static final int ROBOT_STATE = 16;
  private static final int ROBOT_MESSAGE = 20;

  /** No package is longer; one that says so is none. */
  private static final int MAX_BYTES = 1 << 20;

  /** Messages that wait to be taken; of more, the newest are lost. */
  private static final int MAX_WAITING = 20_000;

  /** A controller sends ten states a second; one that is silent for this long is gone. */
  private static final int SILENCE_MS = 5_000;

  private final Socket socket;
  private final BlockingQueue<RobotMessage> waiting = new LinkedBlockingQueue<>(MAX_WAITING);
  private final CompletableFuture<Void> greeted = new CompletableFuture<>();
  private final VariableReader reader = new VariableReader();
  private boolean unreadable;
  private volatile ProgramVariables variables = ProgramVariables.NONE;
  private volatile Optional<IOException> lost = Optional.empty();

  private PrimaryLink(Socket socket) {
    this.socket = socket;
  }

  /**
   * Connects and waits for the first package.
   *
   * @throws IOException if nothing is reached there, or something that is no primary port
   */
  public static PrimaryLink connect(InetSocketAddress address) throws IOException {
    PrimaryLink link = new PrimaryLink(new Socket());
    try {
      link.socket.connect(address, SILENCE_MS);
      link.socket.setTcpNoDelay(true);
      link.socket.setSoTimeout(SILENCE_MS);
      Thread.ofVirtual().name("primary messages").start(link::read);
      await(link.greeted, text("itSendsNothing", SILENCE_MS / 1000));
      return link;
    } catch (IOException e) {
      link.close();
      throw e;
    }
  }

  private static void await(CompletableFuture<Void> done, String late) throws IOException {
    try {
      done.get(SILENCE_MS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new SocketTimeoutException(late);
    } catch (ExecutionException e) {
      throw e.getCause() instanceof IOException why ? why : new IOException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException(text("interrupted"), e);
    }
  }

  private void read() {
    try {
      DataInputStream in = new DataInputStream(socket.getInputStream());
      while (true) {
        take(next(in));
      }
    } catch (IOException e) {
      IOException why =
          switch (e) {
            case SocketTimeoutException _ ->
                new IOException(text("itSendsNothing", SILENCE_MS / 1000), e);
            case EOFException _ -> new IOException(text("itHasClosed"), e);
            default -> e;
          };
      lost = Optional.of(why);
      greeted.completeExceptionally(why);
    }
  }

  private static ByteBuffer next(DataInputStream in) throws IOException {
    int size = in.readInt();
    if (size < HEADER_BYTES || size > MAX_BYTES) {
      throw new IOException(text("packageOfWrongSize", size));
    }
    byte[] rest = new byte[size - Integer.BYTES];
    in.readFully(rest);
    return ByteBuffer.wrap(rest);
  }

  private void take(ByteBuffer packet) throws IOException {
    int type = packet.get();
    if (!greeted.isDone()) {
      if (type != ROBOT_MESSAGE && type != ROBOT_STATE) {
        throw new IOException(text("firstPackageOfOtherType", type));
      }
      greeted.complete(null);
    }
    follow(type, packet);
    if (type == ROBOT_MESSAGE) {
      try {
        RobotMessageDecoder.decode(packet.slice()).ifPresent(waiting::offer);
      } catch (RuntimeException e) {
        throw new IOException(text("messageCutOff"), e);
      }
    }
  }

  /** A controller whose variables cannot be read is good for everything else. */
  private void follow(int type, ByteBuffer packet) {
    if (unreadable) {
      return;
    }
    try {
      if (type == VariablePackages.PROGRAM_STATE) {
        reader.take(packet.slice());
      } else if (type == ROBOT_STATE) {
        reader.pause();
      }
      variables = reader.told();
    } catch (RuntimeException _) {
      unreadable = true;
      variables = ProgramVariables.NONE;
    }
  }

  /** The global variables of the program, as they were told last. */
  public ProgramVariables variables() {
    return variables;
  }

  /** The messages that have come since this was asked before. */
  public List<RobotMessage> take() {
    List<RobotMessage> taken = new ArrayList<>();
    waiting.drainTo(taken);
    return taken;
  }

  /** Why nothing comes any more; empty while the connection lives. */
  public Optional<String> lost() {
    return lost.map(IOException::getMessage);
  }

  /**
   * Sends text, as a port takes it.
   *
   * @param text bytes, one {@code char} a byte
   * @throws IOException if the controller does not take it
   */
  public void send(String text) throws IOException {
    CompletableFuture<Void> sent = new CompletableFuture<>();
    Thread.ofVirtual()
        .start(
            () -> {
              try {
                socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
                sent.complete(null);
              } catch (IOException e) {
                sent.completeExceptionally(e);
              }
            });
    await(sent, text("itTakesNoProgram"));
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
