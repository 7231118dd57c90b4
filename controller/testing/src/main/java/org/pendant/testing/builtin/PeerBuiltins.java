package org.pendant.testing.builtin;

import java.util.Optional;
import org.pendant.controller.bench.Peer;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Peers: the computers that programs open sockets to, played by the test in robot time. */
final class PeerBuiltins {
  private static final String SECTION = "Peers at sockets";
  private static final int MAX_PORT = 65_535;

  /** Characters of what was received that a message shows. */
  private static final int MAX_SHOWN = 200;

  private PeerBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "listen", SECTION)
        .doc(
            "Has the test be the computer that programs reach at this port, by whatever name or"
                + " address: socket_open succeeds from then on.")
        .needs("port", Type.INT)
        .does(
            call -> {
              TestBuiltins.bench(call).peers().listen(call.integer(0, 1, MAX_PORT));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "peer_connected", SECTION)
        .doc("Whether a program is connected to the peer at a port.")
        .needs("port", Type.INT)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(peer(call).connected()));
    TestBuiltins.declare(builtins, "peer_expect", SECTION)
        .doc(
            "Waits until programs have sent this text to the peer at a port, and takes it and what"
                + " came before it away; fails the test if it does not come within some time.")
        .needs("port", Type.INT)
        .needs("text", Type.STRING)
        .takes("within", Unit.SECOND, ExpectationBuiltins.USUAL_S)
        .physicalTime()
        .does(PeerBuiltins::expect);
    TestBuiltins.declare(builtins, "peer_read", SECTION)
        .doc("What programs have sent to the peer at a port, which is taken away by that.")
        .needs("port", Type.INT)
        .returns(Type.STRING)
        .does(
            call -> {
              String received = peer(call).received();
              peer(call).skip(received.length());
              return call.answer(received);
            });
    TestBuiltins.declare(builtins, "peer_send", SECTION)
        .doc("Sends text to the programs that are connected to the peer at a port.")
        .needs("port", Type.INT)
        .needs("text", Type.STRING)
        .does(call -> send(call, ""));
    TestBuiltins.declare(builtins, "peer_send_line", SECTION)
        .doc("As peer_send, with a line end behind the text, which no string can hold.")
        .needs("port", Type.INT)
        .needs("text", Type.STRING)
        .does(call -> send(call, "\n"));
    declareFaults(builtins);
  }

  private static void declareFaults(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "peer_delay", SECTION)
        .doc("Has everything to and from the peer at a port arrive this much later.")
        .needs("port", Type.INT)
        .needs("delay", Unit.SECOND)
        .does(
            call -> {
              double delay = call.number(1);
              if (!(delay >= 0)) {
                throw call.refuse(1, TestTexts.text("notNegative"));
              }
              peer(call).setDelayFrames(FrameTime.framesFor(delay));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "peer_hang_up", SECTION)
        .doc("Closes the connections to the peer at a port, after what was sent before.")
        .needs("port", Type.INT)
        .does(
            call -> {
              peer(call).hangUp();
              return call.answer();
            });
    TestBuiltins.declare(builtins, "peer_refuse", SECTION)
        .doc("Has the peer at a port refuse connections, or accept them again.")
        .needs("port", Type.INT)
        .takes("refuse", Type.BOOL, Value.of(true))
        .does(
            call -> {
              peer(call).setRefuses(call.bool(1));
              return call.answer();
            });
  }

  private static Peer peer(Call<ControlBox> call) throws ScriptError {
    int port = call.integer(0, 1, MAX_PORT);
    return TestBuiltins.bench(call)
        .peers()
        .at(port)
        .orElseThrow(() -> call.failure("no-peer", TestTexts.text("nobodyListens", port)));
  }

  private static Outcome send(Call<ControlBox> call, String end) throws ScriptError {
    if (!peer(call).send(call.text(1) + end)) {
      throw call.failure("no-peer", TestTexts.text("notConnected", call.integer(0)));
    }
    return call.answer();
  }

  private static Outcome expect(Call<ControlBox> call) throws ScriptError {
    double within = call.number(2);
    if (!(within >= 0)) {
      throw call.refuse(2, TestTexts.text("notNegative"));
    }
    return new Expect(peer(call), call.text(1), call.frame() + FrameTime.framesFor(within));
  }

  /** Waits for a text from programs. */
  private record Expect(Peer peer, String text, long deadline) implements Wait {
    @Override
    public Optional<Value> poll(long frame) throws ScriptError {
      String received = peer.received();
      int at = received.indexOf(text);
      if (at >= 0) {
        peer.skip(at + text.length());
        return Optional.of(NoneValue.NONE);
      }
      if (frame >= deadline) {
        String tail = received.substring(Math.max(0, received.length() - MAX_SHOWN));
        throw new ScriptError(
            AssertionCodes.FAILED,
            received.isEmpty()
                ? TestTexts.text("peerNothing", text)
                : TestTexts.text("peerOther", text, tail));
      }
      return Optional.empty();
    }
  }
}
