package org.pendant.protocols.modbusclient;

import static org.pendant.protocols.modbusclient.ModbusClientTexts.text;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Connection to a device, from when it is open to its end. The thread of the device asks, a second
 * one receives. Questions do not wait for the answers of others, unless the device wants it.
 */
final class Conversation {
  /** Most questions that wait for an answer at once. */
  static final int MAX_UNANSWERED = 16;

  /** How long a device may take for an answer. */
  static final long ANSWER_NS = TimeUnit.SECONDS.toNanos(1);

  /** So many questions without an answer, one after the other, and the device counts as gone. */
  private static final int MAX_MISSED = 3;

  /**
   * How long the answer to one question is waited for before the next one is asked all the same:
   * many devices take only the first of two that come at once.
   */
  private static final long APART_NS = TimeUnit.MILLISECONDS.toNanos(1);

  private static final int TRANSACTIONS = 1 << Short.SIZE;

  private final Device device;
  private final Socket socket;
  private final Thread asking = Thread.currentThread();
  private final Map<Integer, Waiting> unanswered = new HashMap<>();
  private final BlockingQueue<byte[]> answers = new ArrayBlockingQueue<>(2 * MAX_UNANSWERED);
  private volatile Optional<IOException> end = Optional.empty();
  private int transaction;
  private int turn;
  private long heardNs = System.nanoTime();

  /** Questions without an answer since something was heard. */
  private int missed;

  private long askedNs;

  /**
   * A question and who has asked it.
   *
   * @param crowded whether another one waited for its answer then
   */
  private record Waiting(Asker asker, DeviceRequest question, long sinceNs, boolean crowded) {}

  /** A conversation of the calling thread. */
  Conversation(Device device, Socket socket) {
    this.device = device;
    this.socket = socket;
  }

  /**
   * Asks and answers until nothing more is wanted of this connection.
   *
   * @throws IOException when the connection ends by itself
   */
  void run() throws IOException {
    Thread receiving = Thread.ofVirtual().name("Modbus receiving").start(this::receive);
    try {
      while (device.wantsToTalk()) {
        takeAnswers();
        giveUpOld(System.nanoTime());
        long waitNs = askWhatIsDue();
        if (answers.isEmpty() && end.isEmpty()) {
          LockSupport.parkNanos(this, waitNs);
        }
      }
    } finally {
      receiving.interrupt();
      unanswered.values().forEach(each -> each.asker().dropped());
    }
  }

  private void receive() {
    try {
      InputStream in = new BufferedInputStream(socket.getInputStream());
      while (true) {
        answers.put(ResponseFrame.read(in));
        LockSupport.unpark(asking);
      }
    } catch (IOException e) {
      end = Optional.of(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      end = Optional.of(new IOException(text("givenUp"), e));
    }
    LockSupport.unpark(asking);
  }

  private void takeAnswers() throws IOException {
    // asked first: what came before the end has been put there by then
    Optional<IOException> over = end;
    for (byte[] frame = answers.poll(); frame != null; frame = answers.poll()) {
      heardNs = System.nanoTime();
      missed = 0;
      // an answer that comes too late belongs to no question
      Waiting waiting = unanswered.remove(ResponseFrame.transaction(frame));
      if (waiting != null) {
        waiting.asker().answered(waiting.question().answer(frame));
      }
    }
    if (over.isPresent()) {
      throw over.get();
    }
  }

  /**
   * A device that says nothing at all is connected to again; one that leaves something out is not,
   * unless several questions at once may have been too much for it. Where it is asked one by one,
   * one question without an answer says nothing about the others.
   */
  private void giveUpOld(long nowNs) throws IOException {
    for (Iterator<Waiting> each = unanswered.values().iterator(); each.hasNext(); ) {
      Waiting waiting = each.next();
      if (nowNs - waiting.sinceNs() >= ANSWER_NS) {
        if (waiting.crowded() && !device.sequential()) {
          device.askOneByOne();
          throw new SocketTimeoutException(text("severalQuestionsAtOnce"));
        }
        each.remove();
        waiting.asker().unanswered();
        if (waiting.sinceNs() - heardNs >= 0) {
          missed++;
        }
      }
    }
    if (missed > 0 && missed >= Math.min(MAX_MISSED, device.askers().size())) {
      throw new SocketTimeoutException(text("noAnswer"));
    }
  }

  /** Sends the questions that are due; answers how long there is nothing more to do, ns. */
  private long askWhatIsDue() throws IOException {
    int most = device.sequential() ? 1 : MAX_UNANSWERED;
    List<? extends Asker> askers = device.askers();
    long nowNs = System.nanoTime();
    long waitNs = oldestNs(nowNs);
    // each has its turn, also where the device does not keep up with all
    for (int i = 0; i < askers.size(); i++) {
      Asker asker = askers.get((turn + i) % askers.size());
      long dueNs = asker.dueInNs(nowNs);
      if (dueNs > 0) {
        waitNs = Math.min(waitNs, dueNs);
      } else if (unanswered.isEmpty()
          || (unanswered.size() < most && nowNs - askedNs >= APART_NS)) {
        send(asker, nowNs);
      } else {
        turn = (turn + i) % askers.size();
        // the next answer wakes this thread
        return unanswered.size() < most ? APART_NS : waitNs;
      }
    }
    return waitNs;
  }

  private long oldestNs(long nowNs) {
    long waitNs = ANSWER_NS;
    for (Waiting each : unanswered.values()) {
      waitNs = Math.min(waitNs, ANSWER_NS - (nowNs - each.sinceNs()));
    }
    return waitNs;
  }

  private void send(Asker asker, long nowNs) throws IOException {
    transaction = (transaction + 1) % TRANSACTIONS;
    DeviceRequest question = asker.ask(nowNs);
    unanswered.put(transaction, new Waiting(asker, question, nowNs, !unanswered.isEmpty()));
    askedNs = nowNs;
    socket.getOutputStream().write(question.frame(transaction));
  }
}
