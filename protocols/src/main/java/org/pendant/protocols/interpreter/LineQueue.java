package org.pendant.protocols.interpreter;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BiConsumer;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Reply;
import org.pendant.script.vm.InterpretedLine;

/** Line queue: the statements of one client on their way to the controller, a few at a time. */
final class LineQueue {
  /** Most lines of one client in a frame: each is checked in the frame loop. */
  private static final int MAX_UNDER_WAY = 16;

  /** Beyond this the client has to wait with what it sends. */
  private static final int MAX_WAITING_BYTES = 1 << 20;

  private final Robot robot;
  private final BiConsumer<InterpretedLine, Reply> answer;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition room = lock.newCondition();
  private final Queue<InterpretedLine> waiting = new ArrayDeque<>();
  private int waitingBytes;
  private int underWay;
  private boolean pumping;

  /**
   * Nothing under way.
   *
   * @param answer gets every line with its reply, in order; called in the frame loop, so short
   */
  LineQueue(Robot robot, BiConsumer<InterpretedLine, Reply> answer) {
    this.robot = robot;
    this.answer = answer;
  }

  /** Puts a line at the end; waits while there are too many. */
  void add(InterpretedLine line) throws InterruptedException {
    lock.lock();
    try {
      while (waitingBytes > MAX_WAITING_BYTES) {
        room.await();
      }
      waiting.add(line);
      waitingBytes += line.text().length();
      pump();
    } finally {
      lock.unlock();
    }
  }

  private void pump() {
    pumping = true;
    while (underWay < MAX_UNDER_WAY && !waiting.isEmpty()) {
      InterpretedLine next = waiting.remove();
      waitingBytes -= next.text().length();
      underWay++;
      var _ =
          robot
              .submit(new InterpreterCommand.Interpret(next))
              .thenAccept(reply -> answered(next, reply));
    }
    pumping = false;
    room.signalAll();
  }

  private void answered(InterpretedLine line, Reply reply) {
    answer.accept(line, reply);
    lock.lock();
    try {
      underWay--;
      // a reply that was there at once came in the middle of pump, which continues by itself
      if (!pumping) {
        pump();
      }
    } finally {
      lock.unlock();
    }
  }
}
