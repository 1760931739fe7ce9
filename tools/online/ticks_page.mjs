// A page without exercises shows what is done, too.
import { start } from './ticks.mjs';

start();
