// Two teams that stand there until this program is ended: node dummies.mjs AGENTPORT [PER_TEAM]
import { twoTeams } from './simspark.mjs';

const [port, perTeam] = process.argv.slice(2).map(Number);
await twoTeams(port, perTeam || 11);
console.log('all there');
setInterval(() => {}, 1000);
