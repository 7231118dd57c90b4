/**
 * A robot controller as one object that anybody can drive. Open {@link
 * org.pendant.controller.Controller} first, then {@code Frame} for what happens in a frame.
 */
package org.pendant.controller;
