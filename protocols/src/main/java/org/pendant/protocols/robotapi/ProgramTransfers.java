package org.pendant.protocols.robotapi;

import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.protocols.http.BodyLimit;
import org.pendant.protocols.http.FormData;
import org.pendant.protocols.http.HttpCall;
import org.pendant.protocols.http.HttpReply;
import org.pendant.protocols.http.HttpStatus;
import org.pendant.protocols.http.LargeBodies;
import org.pendant.protocols.teachpendant.ProgramStore;
import org.pendant.protocols.teachpendant.StoreTrouble;

/** Program transfers: takes programs of PolyScope X from clients, and gives them. Any thread. */
final class ProgramTransfers {
  /** The part of the form that the program is. */
  private static final String FIELD = "file";

  /** What the form around a program may take. */
  private static final int FORM_BYTES = 8192;

  /** So much more is read before it is refused, as clients send all before they read. */
  private static final int MAX_READ = 64 << 20;

  private static final int MAX_AT_ONCE = 16;

  private final ProgramStore store;
  private final BodyLimit limit =
      new BodyLimit(
          ProgramStore.MAX_BYTES + FORM_BYTES, MAX_READ, Optional.of(new LargeBodies(MAX_AT_ONCE)));

  ProgramTransfers(ProgramStore store) {
    this.store = store;
  }

  /** How large the body of an upload may be. */
  BodyLimit limit() {
    return limit;
  }

  /** Does something with a program that has come. */
  @FunctionalInterface
  private interface Use {
    String of(byte[] json) throws StoreTrouble;
  }

  /** Adds a program; one of that name must not be there. */
  HttpReply add(HttpCall call) {
    return taken(call, store::add, "the program is added");
  }

  /** Replaces a program. */
  HttpReply replace(HttpCall call) {
    return taken(call, store::replace, "the program is replaced");
  }

  private static HttpReply taken(HttpCall call, Use use, String done) {
    if (call.notKept().isPresent()) {
      return notKept(call.notKept().get());
    }
    byte[] body = new byte[call.body().remaining()];
    call.body().get(body);
    Optional<byte[]> file =
        FormData.field(call.headers().getOrDefault("content-type", ""), body, FIELD);
    if (file.isEmpty()) {
      return invalid("the body must be multipart/form-data with a part \"" + FIELD + "\"");
    }
    if (file.get().length > ProgramStore.MAX_BYTES) {
      return notKept(HttpStatus.TOO_LARGE);
    }
    try {
      return ApiReply.of(
          new JsonText().with("programName", use.of(file.get())).with("message", done));
    } catch (StoreTrouble e) {
      return refused(e);
    }
  }

  private static HttpReply notKept(HttpStatus why) {
    return why == HttpStatus.TOO_LARGE
        ? ApiReply.refused(
            why,
            "Program too large",
            "a program may have at most " + ProgramStore.MAX_BYTES + " bytes")
        : ApiReply.refused(
            why, "Busy", MAX_AT_ONCE + " programs are being taken already, try again");
  }

  /**
   * Gives a program.
   *
   * @param name as it stood in the path, with percent signs for what cannot stand there
   */
  HttpReply give(String name) {
    try {
      // a plus sign is one in paths
      String plain = URLDecoder.decode(name.replace("+", "%2B"), StandardCharsets.UTF_8);
      ByteBuffer json = ByteBuffer.wrap(store.read(plain));
      String text = StandardCharsets.UTF_8.newDecoder().decode(json).toString();
      return ApiReply.of(text);
    } catch (IllegalArgumentException e) {
      return invalid("the name in the path has a percent sign without two hexadecimal digits");
    } catch (CharacterCodingException e) {
      return ApiReply.refused(
          HttpStatus.INTERNAL, "The program cannot be read", "its file is no text in UTF-8");
    } catch (StoreTrouble e) {
      return refused(e);
    }
  }

  private static HttpReply invalid(String reason) {
    return ApiReply.refused(HttpStatus.UNPROCESSABLE, "Validation Error", reason);
  }

  private static HttpReply refused(StoreTrouble trouble) {
    return switch (trouble.kind()) {
      case EXISTS ->
          ApiReply.refused(HttpStatus.BAD_REQUEST, "Program already exists", trouble.getMessage());
      case MISSING ->
          ApiReply.refused(HttpStatus.NOT_FOUND, "Program not found", trouble.getMessage());
      case OTHER, FULL ->
          ApiReply.refused(HttpStatus.CONFLICT, "Not possible now", trouble.getMessage());
      case WRONG -> invalid(trouble.getMessage());
      case FAILED ->
          ApiReply.refused(
              HttpStatus.INTERNAL, "The disk refuses the program", trouble.getMessage());
    };
  }
}
