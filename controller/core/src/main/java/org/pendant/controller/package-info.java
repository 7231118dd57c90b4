/**
 * Robot controller as one object that a thread can drive. Open {@link
 * org.pendant.controller.Controller} first, then {@code Frame} for what happens in a frame.
 */
package org.pendant.controller;
