package org.pendant.desktop.session;

import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.Frames;

/** Guarded frames: hold a lock while a frame runs, so that others can do something between two. */
final class GuardedFrames implements Frames {
  private final Frames frames;
  private final ReentrantLock lock;

  GuardedFrames(Frames frames, ReentrantLock lock) {
    this.frames = frames;
    this.lock = lock;
  }

  @Override
  public void advance() {
    lock.lock();
    try {
      frames.advance();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void advanceBeforeCommands() {
    lock.lock();
    try {
      frames.advanceBeforeCommands();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void applyCommands() {
    lock.lock();
    try {
      frames.applyCommands();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public boolean waitsForOutside() {
    return frames.waitsForOutside();
  }

  @Override
  public boolean needsNoFrameOnTime() {
    return frames.needsNoFrameOnTime();
  }

  @Override
  public boolean followed() {
    return frames.followed();
  }

  @Override
  public boolean held() {
    return frames.held();
  }

  @Override
  public void wakeBy(Runnable wake) {
    frames.wakeBy(wake);
  }

  @Override
  public void noteLostTime(double sinceStartS) {
    frames.noteLostTime(sinceStartS);
  }
}
