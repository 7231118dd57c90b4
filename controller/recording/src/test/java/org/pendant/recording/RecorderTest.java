package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Reply;
import org.pendant.script.vm.Program;

class RecorderTest {
  @Test
  void theSameProgramAndSeedGiveTheSameRecordByteForByte() throws IOException {
    String text =
        """
        def p():
         thread t():
          while True:
           set_standard_digital_out(0, True)
           sleep(0.01)
          end
         end
         run t()
         movej([1, -1, -1, -1, 1, 1])
         movel(pose_add(get_actual_tcp_pose(), p[0.05, 0.02, -0.04, 0, 0, 0]))
         sleep(0.1)
        end
        """;
    String first = record(text);
    assertEquals(first, record(text));
    assertTrue(first.startsWith("time_s,target_q_0,target_q_1,"), first.substring(0, 40));
    String[] rows = first.split("\n", -1);
    assertEquals(38, rows[0].split(",", -1).length);
    for (int i = 1; i < rows.length - 1; i++) {
      assertEquals(38, rows[i].split(",", -1).length);
      assertEquals(i / 500.0, Double.parseDouble(rows[i].substring(0, rows[i].indexOf(','))));
    }
  }

  private static String record(String text) throws IOException {
    Controller controller = new Controller(ControllerOptions.headless());
    Program program = TestController.program(controller, text);
    CompletableFuture<Reply> started = controller.submit(new ProgramCommand.StartProgram(program));
    StringWriter out = new StringWriter();
    try (Recorder recorder = new Recorder(out)) {
      do {
        controller.advance();
        recorder.write(controller.state());
      } while (controller.state().program().ending().isEmpty());
    }
    assertEquals(new Reply.Done(), started.join());
    return out.toString();
  }
}
