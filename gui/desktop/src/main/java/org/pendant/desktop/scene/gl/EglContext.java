package org.pendant.desktop.scene.gl;

import static org.pendant.desktop.scene.gl.GraphicsTexts.text;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.IntBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.egl.EGL;
import org.lwjgl.egl.EGL10;
import org.lwjgl.egl.EGL12;
import org.lwjgl.egl.EGL14;
import org.lwjgl.egl.EGL15;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GL11C;
import org.lwjgl.system.Configuration;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.pendant.protocols.natives.NativeFolder;

/** EGL context without a window: on Linux with Mesa and others, with a GPU or without. */
final class EglContext implements GlContext {
  /** EGL_PLATFORM_SURFACELESS_MESA: needs neither a display nor a device that is named. */
  private static final int SURFACELESS = 0x31DD;

  private static final String REMEDY = text("remedy");

  private static final String LIBRARY = "libEGL.so.1";

  private final long display;
  private final long context;

  private EglContext(long display, long context) {
    this.display = display;
    this.context = context;
  }

  /** Opens a context and makes it current on the calling thread. */
  static EglContext open() throws SceneUnavailable {
    return open(System.getProperty("os.name"));
  }

  /**
   * @param system the name of the operating system
   */
  static EglContext open(String system) throws SceneUnavailable {
    if (!system.startsWith("Linux")) {
      throw new SceneUnavailable(text("drawsByEgl", system));
    }
    try {
      if (!Configuration.DEBUG.get(false)) {
        // What is missing is said by our own message, in one line.
        Configuration.DEBUG_STREAM.set(new PrintStream(OutputStream.nullOutputStream()));
      }
      Configuration.OPENGL_CONTEXT_API.set("EGL");
      Configuration.SHARED_LIBRARY_EXTRACT_PATH.set(NativeFolder.ofUser().toString());
      if (Configuration.EGL_LIBRARY_NAME.get() == null) {
        SystemLibrary.path(LIBRARY)
            .ifPresent(path -> Configuration.EGL_LIBRARY_NAME.set(path.toString()));
      }
      return openLoaded();
    } catch (IOException e) {
      throw new SceneUnavailable(text("lwjglCannotBeUnpacked", e.getMessage()), e);
    } catch (LinkageError missing) {
      // LWJGL looks for its libraries in static initialisers, so this is how their absence shows.
      throw new SceneUnavailable(text("eglCannotBeLoaded", reason(missing), REMEDY), missing);
    }
  }

  private static EglContext openLoaded() throws SceneUnavailable {
    long display = display();
    if (!EGL12.eglBindAPI(EGL14.EGL_OPENGL_API)) {
      EGL10.eglTerminate(display);
      throw new SceneUnavailable(text("eglHasNoDesktopOpenglHere", REMEDY));
    }
    long context = context(display);
    if (!EGL10.eglMakeCurrent(display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, context)) {
      int error = EGL10.eglGetError();
      EGL10.eglTerminate(display);
      throw new SceneUnavailable(text("openglCannotBeUsedWithoutA", hex(error), REMEDY));
    }
    GL.createCapabilities();
    return new EglContext(display, context);
  }

  /** A display that works: one without any surface, or else the default one. */
  private static long display() throws SceneUnavailable {
    long surfaceless = surfaceless();
    if (surfaceless != EGL10.EGL_NO_DISPLAY && initialised(surfaceless)) {
      return surfaceless;
    }
    long standard = EGL10.eglGetDisplay(EGL14.EGL_DEFAULT_DISPLAY);
    if (standard != EGL10.EGL_NO_DISPLAY && initialised(standard)) {
      return standard;
    }
    throw new SceneUnavailable(text("eglFindsNoGraphicsAndNo", REMEDY));
  }

  private static long surfaceless() {
    long function = EGL.getCapabilities().eglGetPlatformDisplay;
    // LWJGL's method refuses the display 0, which is the right one here.
    return function == MemoryUtil.NULL
        ? EGL10.EGL_NO_DISPLAY
        : JNI.callPPP(SURFACELESS, 0L, 0L, function);
  }

  private static boolean initialised(long display) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer major = stack.mallocInt(1);
      IntBuffer minor = stack.mallocInt(1);
      if (!EGL10.eglInitialize(display, major, minor)) {
        return false;
      }
      EGL.createDisplayCapabilities(display, major.get(0), minor.get(0));
      return true;
    }
  }

  private static long context(long display) throws SceneUnavailable {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      IntBuffer wanted =
          stack.ints(
              EGL10.EGL_SURFACE_TYPE,
              EGL10.EGL_PBUFFER_BIT,
              EGL12.EGL_RENDERABLE_TYPE,
              EGL14.EGL_OPENGL_BIT,
              EGL10.EGL_NONE);
      PointerBuffer config = stack.mallocPointer(1);
      IntBuffer count = stack.mallocInt(1);
      long context = EGL10.EGL_NO_CONTEXT;
      if (EGL10.eglChooseConfig(display, wanted, config, count) && count.get(0) > 0) {
        IntBuffer version =
            stack.ints(
                EGL15.EGL_CONTEXT_MAJOR_VERSION,
                3,
                EGL15.EGL_CONTEXT_MINOR_VERSION,
                3,
                EGL15.EGL_CONTEXT_OPENGL_PROFILE_MASK,
                EGL15.EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                EGL10.EGL_NONE);
        context = EGL10.eglCreateContext(display, config.get(0), EGL10.EGL_NO_CONTEXT, version);
      }
      if (context == EGL10.EGL_NO_CONTEXT) {
        int error = EGL10.eglGetError();
        EGL10.eglTerminate(display);
        throw new SceneUnavailable(text("thereIsNoOpengl33", hex(error), REMEDY));
      }
      return context;
    }
  }

  private static String hex(int error) {
    return "0x" + Integer.toHexString(error);
  }

  private static String reason(Throwable failure) {
    Throwable cause = failure.getCause() == null ? failure : failure.getCause();
    return String.valueOf(cause.getMessage()).lines().findFirst().orElse(text("noReasonGiven"));
  }

  @Override
  public String renderer() {
    return GL11C.glGetString(GL11C.GL_RENDERER);
  }

  @Override
  public void close() {
    GL.setCapabilities(null);
    EGL10.eglMakeCurrent(display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_CONTEXT);
    EGL10.eglDestroyContext(display, context);
    // The display belongs to the process: another scene may use it, so it is not terminated.
  }
}
